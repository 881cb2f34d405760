#include "engine/transport/surface/surface_point.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luxdeck {

namespace {

template <class T>
T interpolate(const std::vector<T>& values, const std::array<std::uint32_t, 3>& t, float u, float v) {
    return values[t[0]] * (1 - u - v) + values[t[1]] * u + values[t[2]] * v;
}

/// The interpolated normal on the geometric one's side; the geometric one where it cannot be used.
Vec3 shadingNormal(const Mesh& mesh, const std::array<std::uint32_t, 3>& t, const Hit& hit, const Vec3& geometric,
                   const Vec3& towardsViewer) {
    Vec3 n = interpolate(mesh.normals, t, hit.u, hit.v);
    const float length2 = n.length2();
    if (!(length2 > 1e-8F)) return geometric;
    n /= std::sqrt(length2);
    if (dot(n, geometric) < 0) n = -n;
    return dot(n, towardsViewer) > 1e-3F ? n : geometric;
}

/// The direction in which u of the texture grows along a triangle; zero where it does not vary.
Vec3 alongU(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
    if (mesh.uvs.empty()) return Vec3(0, 0, 0);
    const Vec3 p1 = mesh.positions[t[1]] - mesh.positions[t[0]], p2 = mesh.positions[t[2]] - mesh.positions[t[0]];
    const Vec2 d1 = mesh.uvs[t[1]] - mesh.uvs[t[0]], d2 = mesh.uvs[t[2]] - mesh.uvs[t[0]];
    const float area = d1.x * d2.y - d2.x * d1.y;
    return (p1 * d2.y - p2 * d1.y) * std::copysign(1.0F, area);
}

}  // namespace

SurfacePoint surfacePoint(const Scene& scene, const SceneNeeds& needs, const Ray& ray, const Hit& hit) {
    const auto& mesh = scene.meshes[hit.mesh];
    const auto& t = mesh.triangles[hit.triangle];
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    SurfacePoint point;
    point.position = a + (b - a) * hit.u + (c - a) * hit.v;
    point.ulp = spacingAt(point.position);
    const Vec3 normal = cross(b - a, c - a).normalized();
    point.frontFace = dot(normal, ray.direction) <= 0;
    point.geometricNormal = point.frontFace ? normal : -normal;
    point.shadingNormal = needs.smoothNormals && !mesh.normals.empty()
                              ? shadingNormal(mesh, t, hit, point.geometricNormal, -ray.direction)
                              : point.geometricNormal;
    if ((needs.textures || needs.patterns) && !mesh.uvs.empty()) point.uv = interpolate(mesh.uvs, t, hit.u, hit.v);
    point.material = &scene.materials[mesh.material];
    point.rayDirection = ray.direction, point.rayDistance = hit.distance;
    return point;
}

Frame surfaceFrame(const Scene& scene, const SurfacePoint& point, const Hit& hit) {
    const auto& m = *point.material;
    const Vec3& n = point.shadingNormal;
    if (m.kind != MaterialKind::Ward || m.wardU == m.wardV) return Frame::about(n);
    const auto& mesh = scene.meshes[hit.mesh];
    const Vec3 grain = m.grain.length2() > 0 ? m.grain : alongU(mesh, mesh.triangles[hit.triangle]);
    const Vec3 tangent = grain - n * dot(grain, n);
    if (!(tangent.length2() > 1e-8F * grain.length2())) return Frame::about(n);  // the grain stands on the surface
    const Vec3 x = tangent.normalized();
    return {x, cross(n, x), n};
}

}  // namespace luxdeck
