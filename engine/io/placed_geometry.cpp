#include "engine/io/placed_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck {

Matrix4d placementMatrix(const GeometryPlacement& placement, bool yUp) {
    const double s = placement.metresPerUnit;
    const Matrix4d axes = yUp ? Matrix4d(s, 0, 0, 0,  //
                                         0, 0, s, 0,  //
                                         0, -s, 0, 0,  //
                                         0, 0, 0, 1)
                              : Matrix4d(s, 0, 0, 0,  //
                                         0, s, 0, 0,  //
                                         0, 0, s, 0,  //
                                         0, 0, 0, 1);
    return axes * placement.transform;
}

namespace {

Vec3d row(const Matrix4d& m, int i) { return {m[i][0], m[i][1], m[i][2]}; }

}  // namespace

bool mirrors(const Matrix4d& m) { return row(m, 0).dot(row(m, 1).cross(row(m, 2))) < 0; }

bool transformNormals(const Matrix4d& m, std::vector<Vec3>& normals) {
    // Cofactors are det * inverse-transpose: the sign of det is taken back out, its size vanishes in normalising.
    const double sign = mirrors(m) ? -1 : 1;
    const Vec3d x = row(m, 1).cross(row(m, 2)) * sign;
    const Vec3d y = row(m, 2).cross(row(m, 0)) * sign;
    const Vec3d z = row(m, 0).cross(row(m, 1)) * sign;
    for (auto& normal : normals) {
        const Vec3d placed = x * double(normal.x) + y * double(normal.y) + z * double(normal.z);
        const double length = placed.length();
        if (!std::isfinite(length) || length <= 0) return false;
        normal = Vec3(placed / length);
    }
    return true;
}

void storeRebased(ScenePart& part, std::vector<PlacedMesh> meshes, const std::vector<Vec3d>& luminairePositions) {
    Box3d bounds;
    for (const auto& mesh : meshes)
        for (const auto& position : mesh.positions) bounds.extendBy(position);
    for (const auto& position : luminairePositions) bounds.extendBy(position);
    Scene& scene = part.scene;
    scene.origin = chooseOrigin(bounds);
    for (std::size_t i = 0; i < luminairePositions.size(); ++i)
        scene.luminaires[i].position = scene.toRebased(luminairePositions[i]);

    scene.meshes.reserve(scene.meshes.size() + meshes.size());
    for (auto& placed : meshes) {
        auto& mesh = scene.meshes.emplace_back(std::move(placed.mesh));
        mesh.positions.reserve(placed.positions.size());
        for (const auto& position : placed.positions) mesh.positions.push_back(scene.toRebased(position));
        std::vector<Vec3d>().swap(placed.positions);  // a mesh in double at a time, not all of them twice
    }
}

bool allFinite(const Scene& scene) {
    return std::all_of(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& mesh) {
        return std::all_of(mesh.positions.begin(), mesh.positions.end(), [](const Vec3& p) { return isFinite(p); });
    });
}

}  // namespace luxdeck
