#include "gui/session/units.h"

#include "engine/core/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace luxdeck::gui {

namespace {
/// A footlambert is 1/pi candela per square foot.
constexpr double kCdM2PerFootlambert = kLuxPerFootcandle / std::numbers::pi;

/// With so many digits after the point that the last shown means something.
std::string fixed(double value, int decimals) { return fmt::format("{:.{}f}", value, std::clamp(decimals, 0, 6)); }
int decimalsOf(double value, int digits) {
    return value == 0 ? 0 : digits - 1 - static_cast<int>(std::floor(std::log10(std::fabs(value))));
}
}  // namespace

double Units::illuminance(double lux) const { return light == LightUnit::Lux ? lux : lux / kLuxPerFootcandle; }
double Units::lux(double shown) const { return light == LightUnit::Lux ? shown : shown * kLuxPerFootcandle; }
double Units::luminance(double cdM2) const { return light == LightUnit::Lux ? cdM2 : cdM2 / kCdM2PerFootlambert; }
double Units::lengthOf(double m) const { return length == LengthUnit::Metres ? m : m / kMetresPerFoot; }
double Units::metres(double shown) const { return length == LengthUnit::Metres ? shown : shown * kMetresPerFoot; }
const char* Units::illuminanceUnit() const { return light == LightUnit::Lux ? "lx" : "fc"; }
const char* Units::luminanceUnit() const { return light == LightUnit::Lux ? "cd/m²" : "fL"; }
const char* Units::lengthUnit() const { return length == LengthUnit::Metres ? "m" : "ft"; }

std::string Units::illuminanceText(double lux) const { return numberText(illuminance(lux)) + " " + illuminanceUnit(); }
std::string Units::luminanceText(double cdM2) const { return numberText(luminance(cdM2)) + " " + luminanceUnit(); }
std::string Units::lengthText(double m) const { return fixed(lengthOf(m), 2) + " " + lengthUnit(); }

std::string numberText(double value) {
    if (!std::isfinite(value)) return "-";
    const double size = std::fabs(value);
    if (size != 0 && (size >= 1e6 || size < 1e-3)) return fmt::format("{:.3g}", value);
    return fixed(value, decimalsOf(value, 3));
}

std::string intervalText(double value, double ci95) {
    if (!std::isfinite(value)) return "-";
    if (!std::isfinite(ci95)) return "not known";
    if (ci95 <= 0) return numberText(value);
    const int decimals = decimalsOf(ci95, ci95 < 10 ? 2 : 1);
    return fixed(value, decimals) + " ± " + fixed(ci95, decimals);
}

}  // namespace luxdeck::gui
