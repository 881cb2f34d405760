#include "gui/view3d/light_colours.h"

#include "tonemap/falsecolor.h"
#include "tonemap/isolines.h"

#include <vtkLookupTable.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

/// A logarithmic scale spans no more than this where its start is not told.
constexpr double kLogSpan = 1e3;

/// What is shown, widened to round numbers.
tonemap::ScaleRange rounded(double low, double high, bool logarithmic) {
    if (!(high > low) || !std::isfinite(high - low) || (logarithmic && high <= 0)) return {logarithmic ? 1.0 : 0.0, 1000};
    const tonemap::Field ends{2, 1, {logarithmic ? std::max(low, high / kLogSpan) : low, high}};
    return tonemap::roundedRange(ends, logarithmic);
}

}  // namespace

ResolvedScale resolved(const LegendScale& legend, double shownLow, double shownHigh) {
    const auto range = legend.automatic ? rounded(shownLow, shownHigh, legend.logarithmic) : tonemap::ScaleRange{legend.low, legend.high};
    ResolvedScale scale{range.low, range.high, legend.logarithmic, legend.map};
    if (scale.logarithmic && scale.high <= 0) scale.high = 1000;
    if (scale.logarithmic && scale.low <= 0) scale.low = scale.high / kLogSpan;
    if (!(scale.high > scale.low)) scale.high = scale.low + std::max(1.0, std::fabs(scale.low) * 0.01);
    return scale;
}

LightColours::LightColours(const ResolvedScale& scale) : scale_(scale) {
    for (int i = 0; i < kSteps; ++i) colours_[static_cast<std::size_t>(i)] = tonemap::colourAt(scale.map, i / (kSteps - 1.0));
}

double LightColours::position(double value) const {
    if (std::isnan(value)) return value;
    const double t = scale_.logarithmic ? value <= 0 ? 0.0 : std::log(value / scale_.low) / std::log(scale_.high / scale_.low)
                                        : (value - scale_.low) / (scale_.high - scale_.low);
    return std::clamp(t, 0.0, 1.0);
}

tonemap::Colour8 LightColours::colour(double value) const {
    const double t = position(value);
    return std::isnan(t) ? tonemap::kNotANumber : colours_[static_cast<std::size_t>(std::lround(t * (kSteps - 1)))];
}

vtkSmartPointer<vtkLookupTable> LightColours::table() const {
    auto table = vtkSmartPointer<vtkLookupTable>::New();
    table->SetNumberOfTableValues(kSteps);
    for (int i = 0; i < kSteps; ++i) {
        const auto& c = colours_[static_cast<std::size_t>(i)];
        table->SetTableValue(i, c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
    }
    if (scale_.logarithmic) table->SetScaleToLog10();
    table->SetTableRange(scale_.low, scale_.high);
    table->SetNanColor(1, 1, 1, 0);
    return table;
}

}  // namespace luxdeck::gui
