#pragma once

#include "engine/core/vec.h"

namespace luxdeck {

/// What the boundary between two transparent media does with unpolarised light.
struct Boundary {
    float reflected = 1;      // [-]; 1 beyond the critical angle, the rest is refracted
    Vec3 refracted{0, 0, 0};  // unit, away from the boundary on its far side; zero when nothing is refracted
};

/// Fresnel's equations and Snell's law.
///
/// wo     unit, away from the boundary, z >= 0 along its normal
/// ratio  index of refraction of the far side over that of wo's side
Boundary boundaryLight(const Vec3& wo, float ratio);

}  // namespace luxdeck
