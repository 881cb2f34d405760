#pragma once

#include "engine/core/vec.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

/// Square to unit disc, area preserving. Source: Shirley & Chiu 1997.
inline Vec2 concentricDisc(Vec2 u) {
    const float a = 2 * u.x - 1, b = 2 * u.y - 1;
    if (a == 0 && b == 0) return {0, 0};
    const bool wide = std::abs(a) > std::abs(b);
    const float radius = wide ? a : b;
    const float angle = wide ? kPi / 4 * (b / a) : kPi / 2 - kPi / 4 * (a / b);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// A direction of the hemisphere about +z with density cos / pi.
inline Vec3 cosineHemisphere(Vec2 u) {
    const Vec2 d = concentricDisc(u);
    return {d.x, d.y, std::sqrt(std::max(0.0F, 1 - d.x * d.x - d.y * d.y))};
}

/// A direction of the whole sphere with density sin(e) / pi^2, e from the +z axis: what a vertical
/// cylinder's illuminance weighs by.
Vec3 sineSphere(Vec2 u);

}  // namespace luxdeck
