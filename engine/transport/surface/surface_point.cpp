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
    if (needs.textures && !mesh.uvs.empty()) point.uv = interpolate(mesh.uvs, t, hit.u, hit.v);
    point.material = &scene.materials[mesh.material];
    return point;
}

}  // namespace luxdeck
