#pragma once

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "tonemap/colour_map.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace luxdeck::tonemap {

/// A field of numbers to be shown, rows from the top: #S = width * height.
struct Field {
    int width = 0;
    int height = 0;
    std::vector<double> values;
};

/// Luminance of a picture [cd/m^2], by its own weights; its Y where it has no colours.
///
/// errors  InvalidArgument: no pixels, or neither R, G, B nor Y
Result<Field> luminanceField(const Image& image);

struct ScaleRange {
    double low = 0;
    double high = 1;
};

/// Round numbers about the field's finite values: from its 0.5th to its 99.9th percentile on a logarithmic scale
/// (1-2-5, six decades at most, only values above 0 count); on a linear one from 0 to a multiple of a 1-2-5 step.
/// 0 to 1 (0.1 to 1) for an empty or black field.
ScaleRange roundedRange(const Field& field, bool logarithmic);

struct IsolineStyle {
    std::vector<double> levels;   ///< empty: round ones over the range
    bool labels = true;
    Colour8 colour{255, 255, 255};
    Colour8 halo{0, 0, 0};        ///< under lines and labels, so that they are seen on any ground
};

struct FalseColourSettings {
    ColourMap map = ColourMap::Dusk;
    bool logarithmic = true;
    std::optional<ScaleRange> range;     ///< unset: roundedRange()
    std::string quantity = "Luminance";  ///< above the legend
    std::string unit = "cd/m^2";         ///< "lx" for illuminance
    bool legend = true;
    std::optional<IsolineStyle> isolines;
};

/// The field in colours, with its legend in a panel on the right. Values beyond the range take the end's
/// colour; values that are not finite are kNotANumber, and the legend says so. The text of the result tells range,
/// scale, unit and how many values were below, above and not finite. No tone curve, no colour management.
///
/// errors  InvalidArgument: no values, a size that does not agree, a range that is empty (or not above 0 when
/// logarithmic)
Result<DisplayImage> falseColour(const Field& field, const FalseColourSettings& settings);

/// Draws lines of equal value over a picture of the field (false colour or tone-mapped); the picture may be wider
/// than the field by a legend. The field is averaged to 400 samples a side first, so that noise does not fray the
/// lines.
///
/// errors  InvalidArgument: as falseColour(), or a picture smaller than the field
Result<void> drawIsolines(DisplayImage& image, const Field& field, const IsolineStyle& style, bool logarithmic);

/// A number for a label: four digits, no trailing zeros, thousands apart: "0.05", "20 000", "3e6".
std::string labelOf(double value);

}  // namespace luxdeck::tonemap
