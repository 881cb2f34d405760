#pragma once

#include "engine/core/result.h"
#include "engine/core/rgb.h"
#include "engine/io/pattern_axis.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck {

/// The picture of a colorpict: the file's own numbers, without exposure or change of primaries, which is how
/// Radiance uses them. The lower left pixel is in the origin, the shorter side is 1 long. Constant once read.
class PatternPicture {
public:
    /// Radiance RGBE.
    /// errors  those of parseRgbe(); Unsupported (XYZE)
    static Result<std::shared_ptr<const PatternPicture>> parse(std::string_view bytes,
                                                               const std::filesystem::path& name);

    /// Linear between pixels; NaN for coordinates that are not finite.
    [[nodiscard]] Rgb value(double u, double v) const;

    [[nodiscard]] const std::string& hash() const { return hash_; }  ///< of the file

private:
    DataAxis across_, up_;     // places of pixels
    std::vector<Rgb> pixels_;  // rows from the bottom
    std::string hash_;
};

}  // namespace luxdeck
