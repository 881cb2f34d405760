#pragma once

#include "engine/core/primaries.h"
#include "engine/core/result.h"

#include <string>
#include <string_view>

namespace luxdeck {

/// What stands before the pixels of a Radiance picture.
struct RgbeHeader {
    bool xyz = false;                ///< FORMAT is 32-bit_rle_xyze
    double exposure = 1;             ///< product of all EXPOSURE= lines; pixels are divided by it
    Rgb correction{1.0F};            ///< product of all COLORCORR= lines, the same
    double pixelAspect = 1;          ///< product of all PIXASPECT= lines
    Chromaticities primaries = kRadianceChromaticities;
    std::string view;                ///< the last VIEW= line's options; empty without one
    int width = 0;                   ///< of the picture as seen
    int height = 0;
    bool columnsFirst = false;       ///< scanlines are columns: the resolution line names X first
    bool fromRight = false;          ///< -X: x falls along the file
    bool fromBottom = false;         ///< +Y: y rises along the file
    std::size_t byteSize = 0;        ///< pixels begin here

    [[nodiscard]] int scanlineLength() const { return columnsFirst ? height : width; }
    [[nodiscard]] int scanlineCount() const { return columnsFirst ? width : height; }
};

/// Reads the header; sizes are within kLargestImageSide.
///
/// errors  Parse: "name:line: what was seen, what was expected"
Result<RgbeHeader> parseRgbeHeader(std::string_view bytes, const std::string& name);

}  // namespace luxdeck
