#include "engine/io/project_colour.h"

#include "engine/core/primaries.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

constexpr double kPlanckUpToK = 4000;
constexpr double kDaylightFromK = 5000;
constexpr double kWhiteK = 6500;

struct Chromaticity {
    double x = 0, y = 0;
};

double cubic(double a, double b, double c, double d, double t) { return ((a * t + b) * t + c) * t + d; }

Chromaticity planckian(double kelvin) {
    const double t = 1000.0 / kelvin;
    const double x = kelvin <= 4000 ? cubic(-0.2661239, -0.2343589, 0.8776956, 0.179910, t)
                                    : cubic(-3.0258469, 2.1070379, 0.2226347, 0.240390, t);
    if (kelvin <= 2222) return {x, cubic(-1.1063814, -1.34811020, 2.18555832, -0.20219683, x)};
    if (kelvin <= 4000) return {x, cubic(-0.9549476, -1.37418593, 2.09137015, -0.16748867, x)};
    return {x, cubic(3.0817580, -5.87338670, 3.75112997, -0.37001483, x)};
}

/// Defined from 4000 K.
Chromaticity daylight(double kelvin) {
    const double t = 1000.0 / kelvin;
    const double x = kelvin <= 7000 ? cubic(-4.6070, 2.9678, 0.09911, 0.244063, t)
                                    : cubic(-2.0064, 1.9018, 0.24748, 0.237040, t);
    return {x, cubic(0, -3.000, 2.870, -0.275, x)};
}

Chromaticity locus(double kelvin) {
    if (kelvin <= kPlanckUpToK) return planckian(kelvin);
    if (kelvin >= kDaylightFromK) return daylight(kelvin);
    const double mix = (kelvin - kPlanckUpToK) / (kDaylightFromK - kPlanckUpToK);
    const auto p = planckian(kelvin), d = daylight(kelvin);
    return {p.x + mix * (d.x - p.x), p.y + mix * (d.y - p.y)};
}

/// Linear Rec.709 of luminance 1, negatives and all.
Imath::V3d rec709(const Chromaticity& c) {
    const Imath::V3d xyz(c.x / c.y, 1.0, (1.0 - c.x - c.y) / c.y);
    return xyz * rgbToXyz(kRec709Chromaticities).inverse();
}

}  // namespace

Rgb daylightColour(double kelvin) {
    const auto white = rec709(locus(kWhiteK));
    auto rgb = rec709(locus(std::clamp(kelvin, kLowestColourTemperatureK, kHighestColourTemperatureK)));
    for (int i = 0; i < 3; ++i) rgb[i] = std::max(rgb[i] / white[i], 0.0);
    rgb /= kRec709.r * rgb.x + kRec709.g * rgb.y + kRec709.b * rgb.z;
    return {static_cast<float>(rgb.x), static_cast<float>(rgb.y), static_cast<float>(rgb.z)};
}

}  // namespace luxdeck
