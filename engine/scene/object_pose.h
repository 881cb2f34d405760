#pragma once

#include "engine/core/vec.h"
#include "engine/scene/mesh.h"

namespace luxdeck {

/// Where an object stands: turned about the vertical through its pivot, then shifted from where it was.
struct Pose {
    Vec3d moveM{0, 0, 0};
    double turnDeg = 0;  // counter-clockwise as seen from above

    friend bool operator==(const Pose&, const Pose&) = default;
};

/// A turn about the vertical and a shift, quick to apply.
struct Placement {
    float cosine = 1, sine = 0;
    Vec3 shift{0, 0, 0};  // of the pivot: re-based [m]

    [[nodiscard]] Vec3 direction(const Vec3& d) const { return {cosine * d.x - sine * d.y, sine * d.x + cosine * d.y, d.z}; }
    [[nodiscard]] Vec3 back(const Vec3& d) const { return {cosine * d.x + sine * d.y, cosine * d.y - sine * d.x, d.z}; }
    [[nodiscard]] Vec3 point(const Vec3& p) const { return direction(p) + shift; }
};

/// What an object turns about: the centre of its bounds, at their foot.
Vec3d pivotOf(const Box3d& bounds);
/// Of a mesh's triangles, whatever vertices it has beside.
Box3d triangleBounds(const Mesh& mesh);
/// Of points that are given from the pivot.
Placement placementOf(const Vec3d& pivot, const Pose& pose);
/// Moves a mesh that stands about its object's pivot.
void moveMesh(Mesh& mesh, const Vec3d& pivot, const Placement& place);

}  // namespace luxdeck
