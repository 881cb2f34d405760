#pragma once

#include "engine/core/rgb.h"
#include "engine/scene/scene.h"

#include <span>
#include <string>
#include <vector>

namespace luxdeck {

/// A scene as Radiance text, to be read in this order: materials, geometry, sky.
struct RadText {
    std::string materials;
    std::string geometry;
    std::string sky;                ///< empty: there is none
    std::vector<std::string> lost;  ///< what has no form in Radiance and was left out or made simpler
};

/// Every triangle becomes a polygon of the same corners, in user coordinates and metres: read again, they are the same
/// to the bit when the origin is. Colours become Radiance's primaries, luminances radiances (over 179 lm/W).
/// Luminaires are left out and named: ies2rad makes them of their photometric files.
RadText writeRad(const Scene& scene);

/// A line for each point: `x y z nx ny nz`, as rtrace -I reads it.
std::string writePoints(std::span<const Vec3d> points, std::span<const Vec3d> normals);

}  // namespace luxdeck
