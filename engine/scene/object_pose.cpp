#include "engine/scene/object_pose.h"


#include <cmath>

namespace luxdeck {

Vec3d pivotOf(const Box3d& bounds) { return {(bounds.min.x + bounds.max.x) / 2, (bounds.min.y + bounds.max.y) / 2, bounds.min.z}; }

Box3d triangleBounds(const Mesh& mesh) {
    Box3d bounds;
    for (const auto& triangle : mesh.triangles)
        for (const auto vertex : triangle) bounds.extendBy(Vec3d(mesh.positions[vertex]));
    return bounds;
}

Placement placementOf(const Vec3d& pivot, const Pose& pose) {
    // Quarter turns are exact: a desk turned by 90 degrees has its edges along the axes.
    const double turns = pose.turnDeg / 90;
    const bool quarter = turns == std::round(turns);
    const double angle = pose.turnDeg * kDegree;
    Placement out;
    out.cosine = static_cast<float>(quarter ? std::round(std::cos(angle)) : std::cos(angle));
    out.sine = static_cast<float>(quarter ? std::round(std::sin(angle)) : std::sin(angle));
    out.shift = Vec3(pivot + pose.moveM);
    return out;
}

void moveMesh(Mesh& mesh, const Vec3d& pivot, const Placement& place) {
    const Vec3 from(pivot);
    for (auto& p : mesh.positions) p = place.point(p - from);
    for (auto& n : mesh.normals) n = place.direction(n);
}

}  // namespace luxdeck
