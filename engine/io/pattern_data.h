#pragma once

#include "engine/core/result.h"
#include "engine/io/pattern_axis.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck {

/// The data of a brightdata or colordata: values over up to kMostAxes dimensions. Constant once it is read.
class DataTable {
public:
    static constexpr std::size_t kMostAxes = 5;

    /// Radiance's .dat: the number of dimensions; for each "begin end count", or "0 0 count" and count points; then
    /// the values, the last dimension fastest. "#" begins a comment; what follows the values is left alone.
    ///
    /// errors  Parse, "name:line": what was seen, what was expected
    static Result<std::shared_ptr<const DataTable>> parse(std::string_view text, const std::string& name);

    [[nodiscard]] std::span<const DataAxis> axes() const { return axes_; }
    [[nodiscard]] const std::string& hash() const { return hash_; }  ///< of the text

    /// Linear in each dimension. NaN for coordinates that are not finite.
    /// at   one coordinate an axis
    [[nodiscard]] double value(std::span<const double> at) const;

private:
    std::vector<DataAxis> axes_;
    std::vector<double> values_;
    std::string hash_;
};

}  // namespace luxdeck
