#pragma once

#include "engine/core/vec.h"
#include "engine/raycast/raycaster.h"
#include "engine/transport/radiance_estimator.h"

#include <array>
#include <cstdint>

namespace luxdeck {

/// How far one sees along a surface from one of its points, by azimuth: what a wall that stands on a floor hides of it.
struct Horizon {
    static constexpr int kSectors = 32;
    std::array<float, kSectors> distance{};  // along the surface [m]; in directions(k)

    /// The k-th direction about +z, and the place of a direction among them, 0 .. kSectors. Equal steps of the L1 circle: no atan2.
    static Vec3 direction(int k);
    static float sectorOf(float x, float y);

    /// What it tells of a point of the surface's plane.
    enum class Tells { Seen, Hidden, Nothing };
    /// Seen when the point is nearer than what both directions about it meet, hidden when it is further than both, with some
    /// room for what may lie between the two: a straight wall is nearest at most 1 % nearer there.
    ///
    /// way  from the record to the point, in the frame about the geometric normal
    [[nodiscard]] Tells of(const Vec3& way) const;
};

/// What stands around a point of a surface.
struct Surroundings {
    float meanDistance = kInfinity;   // harmonic, by projected solid angle [m]
    Horizon horizon;
};

/// Panes are looked through. 128 rays.
///
/// position  just off the surface
Surroundings lookAround(const Raycaster& raycaster, const Vec3& position, const Vec3& geometricNormal, std::uint64_t seed);

}  // namespace luxdeck
