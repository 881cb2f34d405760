#pragma once

#include "engine/raycast/raycaster.h"
#include "engine/transport/surface/surface_point.h"
#include "engine/volume/volume.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace luxdeck {

/// What all that interpolates from the corners of a cell agrees on.

/// Of the eight corners, in the lattice's order; they sum to 1.
inline std::array<float, 8> trilinearWeights(const Vec3& fraction) {
    const float x0 = 1 - fraction.x, y0 = 1 - fraction.y, z0 = 1 - fraction.z;
    return {x0 * y0 * z0,         fraction.x * y0 * z0,         x0 * fraction.y * z0,         fraction.x * fraction.y * z0,
            x0 * y0 * fraction.z, fraction.x * y0 * fraction.z, x0 * fraction.y * fraction.z, fraction.x * fraction.y * fraction.z};
}

/// A corner with no weight where the point lies on a side of the cell still counts this much when all others are hidden.
inline constexpr float kLeastWeight = 1e-6F;

/// Whether something may stand between a point and the corners of its cell. Beyond the lattice the way to a corner
/// leaves the cell, and may cross what the cell does not hold.
inline bool cornersMayBeHidden(const IrradianceVolume& volume, const Lattice::Place& place, const Vec3& from) {
    return volume.occupied[place.cell] != 0 || !volume.lattice.bounds().intersects(from);
}

/// Off a surface by a hair, to the side of its normal.
inline Vec3 liftedOff(const Vec3& position, const Vec3& normal) { return position + normal * (16 * spacingAt(position)); }

inline Ray rayBetween(const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const float length = way.length();
    return {from, 0, length > 0 ? way / length : Vec3(0, 0, 1), length};
}

/// Usable corners of a cell and of those that touch it, each once, by increasing index.
///
/// returns  how many of `found` there are
std::size_t usableAround(const IrradianceVolume& volume, std::uint32_t cell, std::array<std::uint32_t, 216>& found);

}  // namespace luxdeck
