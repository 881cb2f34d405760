#include "engine/transport/irradiance_cache/surface_points.h"

#include "engine/transport/surface/surface_point.h"

#include <array>
#include <cmath>

namespace luxdeck {

namespace {

bool mayBeMatte(const Scene& scene, const Material& m) {
    if (m.kind != MaterialKind::Mix) return m.kind == MaterialKind::Matte;
    return scene.materials[m.mixFirst].kind == MaterialKind::Matte || scene.materials[m.mixSecond].kind == MaterialKind::Matte;
}

constexpr double kByRoot = 0.15;

double areaOf(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    return (b - a).cross(c - a).length() / 2;
}

}  // namespace

SurfacePoints::SurfacePoints(const TransportScene& scene, std::uint64_t seed) : scene_(scene), seed_(seed) {
    std::vector<double> areas;
    double area = 0, roots = 0;
    for (std::uint32_t m = 0; m < scene.scene.meshes.size(); ++m) {
        const auto& mesh = scene.scene.meshes[m];
        if (!mayBeMatte(scene.scene, scene.scene.materials[mesh.material])) continue;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            triangles_.push_back({m, t});
            areas.push_back(areaOf(mesh, mesh.triangles[t]));
            area += areas.back(), roots += std::sqrt(areas.back());
        }
    }
    for (auto& a : areas) a = (1 - kByRoot) * a / area + kByRoot * std::sqrt(a) / roots;
    if (!empty()) chances_ = AliasTable(areas);
}

FieldPoint SurfacePoints::at(std::uint32_t i) const {
    SamplePath numbers(seed_, i);
    const auto& chosen = triangles_[chances_.draw(numbers.next1D()).index];
    const Vec2 u = numbers.next2D();
    const float root = std::sqrt(u.x), side = numbers.next1D();
    Hit hit;
    hit.mesh = chosen.mesh, hit.triangle = chosen.triangle, hit.distance = 1;
    hit.u = root * (1 - u.y), hit.v = root * u.y;
    const auto& mesh = scene_.scene.meshes[hit.mesh];
    const auto& t = mesh.triangles[hit.triangle];
    const Vec3 normal = cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]).normalized();
    const Ray towards{{0, 0, 0}, 0, side < 0.5F ? -normal : normal, kInfinity};  // as if met straight from that side
    const auto point = surfacePoint(scene_.scene, scene_.needs, towards, hit);
    return {point.departure(point.geometricNormal), point.shadingNormal, point.geometricNormal, hit.mesh, hit.triangle, hit.u, hit.v, point.frontFace};
}

}  // namespace luxdeck
