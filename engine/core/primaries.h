#pragma once

#include "engine/core/rgb.h"

#include <Imath/ImathMatrix.h>

namespace luxdeck {

/// CIE 1931 xy of a space's primaries and of its white.
struct Chromaticities {
    double redX = 0.64, redY = 0.33;  // Rec.709
    double greenX = 0.30, greenY = 0.60;
    double blueX = 0.15, blueY = 0.06;
    double whiteX = 0.3127, whiteY = 0.3290;

    friend constexpr bool operator==(const Chromaticities&, const Chromaticities&) = default;
};

inline constexpr Chromaticities kRec709Chromaticities{};
/// Radiance's default: the primaries it had in 1997, about the white of equal energy.
inline constexpr Chromaticities kRadianceChromaticities{0.640, 0.330, 0.290, 0.600, 0.150, 0.060, 1.0 / 3.0, 1.0 / 3.0};

/// False when the primaries span no area, or a number is not finite: then no matrix exists.
bool isUsable(const Chromaticities& c);

/// Linear RGB to CIE XYZ, Y = 1 for white; row vectors: xyz = rgb * M. Needs isUsable(c).
Imath::M33d rgbToXyz(const Chromaticities& c);

/// The luminance of a unit of each primary. Rec.709's come back as kRec709 exactly.
LuminanceWeights luminanceWeights(const Chromaticities& c);

/// The known space that has these weights (to 0.002): Rec.709 or Radiance's. Rec.709 when there is none.
Chromaticities chromaticitiesOf(const LuminanceWeights& weights);

/// Linear RGB of one space to another: white goes to white, and luminance is kept exactly for every
/// colour (a luminance meter must not change its reading with the file format). The white is adapted by
/// scaling X and Z, the one diagonal adaptation that leaves Y alone. Row vectors.
Imath::M33d rgbToRgb(const Chromaticities& from, const Chromaticities& to);

/// CIE XYZ about the equal-energy white to linear RGB, adapted in the same way. Row vectors.
Imath::M33d xyzToRgb(const Chromaticities& to);

/// rgb * M, as floats.
inline Rgb transformed(const Rgb& c, const Imath::M33d& m) {
    return {static_cast<float>(c.r * m[0][0] + c.g * m[1][0] + c.b * m[2][0]),
            static_cast<float>(c.r * m[0][1] + c.g * m[1][1] + c.b * m[2][1]),
            static_cast<float>(c.r * m[0][2] + c.g * m[1][2] + c.b * m[2][2])};
}

}  // namespace luxdeck
