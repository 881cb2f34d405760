#pragma once

#include "gui/session/display.h"
#include "tonemap/canvas.h"

#include <vtkSmartPointer.h>

#include <array>

class vtkLookupTable;

namespace luxdeck::gui {

/// The scale of colours as it is used: a range that is not empty, whether the user set it or it followed from what is shown.
struct ResolvedScale {
    double low = 0, high = 1000;  ///< [lx]; spheres of radiance: [cd/m²]. 0 < low when logarithmic
    bool logarithmic = false;
    tonemap::ColourMap map = tonemap::ColourMap::Dusk;

    friend bool operator==(const ResolvedScale&, const ResolvedScale&) = default;
};

/// The user's range, or the one shown rounded to round numbers where the user leaves it to the program. A logarithmic scale
/// starts above zero: at a thousandth of its end where there is no other start.
///
/// shownLow, shownHigh  what all views show together; empty (high <= low): 0 .. 1000
ResolvedScale resolved(const LegendScale& legend, double shownLow, double shownHigh);

/// Colours of light on a scale: of everything that the views show in false colour, and of the legend.
class LightColours {
public:
    explicit LightColours(const ResolvedScale& scale);

    /// Beyond the range the ends' colours; what is not a number has tonemap::kNotANumber.
    [[nodiscard]] tonemap::Colour8 colour(double value) const;
    /// 0 .. 1 along the scale, clamped; NaN stays NaN.
    [[nodiscard]] double position(double value) const;
    /// The same for VTK's mappers: give them values, not colours. NaN is transparent in it.
    [[nodiscard]] vtkSmartPointer<vtkLookupTable> table() const;
    [[nodiscard]] const ResolvedScale& scale() const { return scale_; }

private:
    static constexpr int kSteps = 1024;

    ResolvedScale scale_;
    std::array<tonemap::Colour8, kSteps> colours_;
};

}  // namespace luxdeck::gui
