#include "engine/core/primaries.h"

#include <cmath>

namespace luxdeck {

namespace {

Imath::V3d xyzOf(double x, double y) { return {x / y, 1.0, (1.0 - x - y) / y}; }

Imath::M33d diagonal(const Imath::V3d& d) { return {d.x, 0, 0, 0, d.y, 0, 0, 0, d.z}; }

/// Rows are the XYZ of the primaries, each at Y = 1.
Imath::M33d primaryRows(const Chromaticities& c) {
    const auto r = xyzOf(c.redX, c.redY), g = xyzOf(c.greenX, c.greenY), b = xyzOf(c.blueX, c.blueY);
    return {r.x, r.y, r.z, g.x, g.y, g.z, b.x, b.y, b.z};
}

/// Scales X and Z so that the white of `from` becomes that of `to`.
Imath::M33d adaptation(const Imath::V3d& from, const Imath::V3d& to) {
    return diagonal({to.x / from.x, 1.0, to.z / from.z});
}

bool near(const LuminanceWeights& a, const LuminanceWeights& b, double tolerance) {
    return std::abs(a.r - b.r) <= tolerance && std::abs(a.g - b.g) <= tolerance && std::abs(a.b - b.b) <= tolerance;
}

}  // namespace

bool isUsable(const Chromaticities& c) {
    for (const double y : {c.redY, c.greenY, c.blueY, c.whiteY})
        if (!(std::abs(y) > 1e-6)) return false;
    for (const double v : {c.redX, c.redY, c.greenX, c.greenY, c.blueX, c.blueY, c.whiteX, c.whiteY})
        if (!(std::abs(v) < 10)) return false;
    const double area = (c.greenX - c.redX) * (c.blueY - c.redY) - (c.blueX - c.redX) * (c.greenY - c.redY);
    const bool whiteHasXAndZ = c.whiteX > 1e-6 && 1 - c.whiteX - c.whiteY > 1e-6;
    return std::abs(area) > 1e-6 && whiteHasXAndZ;
}

Imath::M33d rgbToXyz(const Chromaticities& c) {
    const Imath::M33d rows = primaryRows(c);
    const Imath::V3d white = xyzOf(c.whiteX, c.whiteY);
    const Imath::M33d inverse = rows.inverse();
    // Amounts of the primaries that make white: white * rows^-1.
    Imath::V3d amounts;
    for (int i = 0; i < 3; ++i)
        amounts[i] = white.x * inverse[0][i] + white.y * inverse[1][i] + white.z * inverse[2][i];
    return diagonal(amounts) * rows;
}

LuminanceWeights luminanceWeights(const Chromaticities& c) {
    if (c == kRec709Chromaticities) return kRec709;
    const Imath::M33d m = rgbToXyz(c);
    const LuminanceWeights weights{m[0][1], m[1][1], m[2][1]};
    // Files hold chromaticities as floats: what is Rec.709 but for that is Rec.709.
    return near(weights, kRec709, 1e-4) ? kRec709 : weights;
}

Chromaticities chromaticitiesOf(const LuminanceWeights& weights) {
    if (near(weights, kRec709, 1e-4)) return kRec709Chromaticities;
    const Imath::M33d radiance = rgbToXyz(kRadianceChromaticities);
    const bool isRadiance = near(weights, {radiance[0][1], radiance[1][1], radiance[2][1]}, 2e-3);
    return isRadiance ? kRadianceChromaticities : kRec709Chromaticities;
}

Imath::M33d rgbToRgb(const Chromaticities& from, const Chromaticities& to) {
    if (from == to) return {};
    return rgbToXyz(from) * adaptation(xyzOf(from.whiteX, from.whiteY), xyzOf(to.whiteX, to.whiteY)) *
           rgbToXyz(to).inverse();
}

Imath::M33d xyzToRgb(const Chromaticities& to) {
    return adaptation({1, 1, 1}, xyzOf(to.whiteX, to.whiteY)) * rgbToXyz(to).inverse();
}

}  // namespace luxdeck
