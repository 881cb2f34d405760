#include "tonemap/mesopic.h"

#include "engine/core/primaries.h"

#include <algorithm>

namespace luxdeck::tonemap {

namespace {

/// Scotopic over photopic luminance of a colour. Deep blues have an X near 0, where the fit runs away: the ratio
/// (Y + Z) / X is held below 20, three times that of Rec.709's blue.
double scotopicRatio(double x, double y, double z) {
    const double ratio = (y + z) / std::max(x, (y + z) / 20);
    return std::max(1.33 * (1 + ratio) - 1.68, 0.0);
}

}  // namespace

double scotopicLuminance(const Rgb& c) {
    static const Imath::M33d m = rgbToXyz(kRec709Chromaticities);
    static const double white = scotopicRatio(m[0][0] + m[1][0] + m[2][0], 1, m[0][2] + m[1][2] + m[2][2]);
    const double y = luminance(c);
    if (!(y > 0)) return 0;
    const double x = c.r * m[0][0] + c.g * m[1][0] + c.b * m[2][0];
    const double z = c.r * m[0][2] + c.g * m[1][2] + c.b * m[2][2];
    return y * scotopicRatio(x, y, z) / white;
}

Rgb withNightColours(const Rgb& colour) {
    const double y = luminance(colour);
    if (y >= kPhotopicAbove) return colour;
    const auto cones =
        static_cast<float>(std::clamp((y - kScotopicBelow) / (kPhotopicAbove - kScotopicBelow), 0.0, 1.0));
    return colour * cones + Rgb(static_cast<float>(scotopicLuminance(colour))) * (1 - cones);
}

}  // namespace luxdeck::tonemap
