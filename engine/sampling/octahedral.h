#pragma once

#include "engine/core/vec.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

/// The unit direction at (u, v) of a sphere folded out to a square, both in 0 .. 1.
inline Vec3 octahedralDirection(float u, float v) {
    const float x = 2 * u - 1, y = 2 * v - 1;
    Vec3 d{x, y, 1 - std::abs(x) - std::abs(y)};
    if (d.z < 0) {
        d.x = std::copysign(1 - std::abs(y), x);
        d.y = std::copysign(1 - std::abs(x), y);
    }
    return d.normalized();
}

/// The texel, row-major in a square of side x side, that holds a direction of any length.
inline int octahedralTexel(const Vec3& d, int side) {
    const float toOctahedron = 1 / (std::abs(d.x) + std::abs(d.y) + std::abs(d.z) + 1e-30F);
    const float ox = d.x * toOctahedron, oy = d.y * toOctahedron;
    const float fx = d.z < 0 ? std::copysign(1 - std::abs(oy), ox) : ox;
    const float fy = d.z < 0 ? std::copysign(1 - std::abs(ox), oy) : oy;
    const float half = 0.5F * static_cast<float>(side);
    const auto cell = [&](float f) { return std::clamp(static_cast<int>((f + 1) * half), 0, side - 1); };
    return cell(fy) * side + cell(fx);
}

}  // namespace luxdeck
