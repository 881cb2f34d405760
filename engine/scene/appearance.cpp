#include "engine/scene/appearance.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace luxdeck {

namespace {

/// A light whose few probes all fell on black texels is still asked this often, against its plain emission.
constexpr float kDefensive = 0.1F;

constexpr int kProbes = 16;

/// A quasi-random number of a probe. With the four powers of 1 / 1.1673 (the root of x^5 = x + 1) as steps the
/// probes spread evenly in four dimensions. Source: Roberts 2018, the R sequence.
float probeNumber(int probe, float step) {
    const float x = 0.5F + static_cast<float>(probe) * step;
    return x - std::floor(x);
}

/// Where a probe looks at the triangle: a point of it and a direction, cosine-weighted about its normal.
PatternPoint probePoint(const Scene& scene, const Mesh& mesh, std::uint32_t triangle, int probe) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const float root = std::sqrt(probeNumber(probe, 0.8567F)), split = probeNumber(probe, 0.7339F);
    const float wa = 1 - root, wb = root * (1 - split), wc = root * split;
    const Vec3 normal = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).normalized();
    const float sine2 = probeNumber(probe, 0.6287F), turn = 2 * kPi * probeNumber(probe, 0.5386F);
    const float sine = std::sqrt(sine2);
    const Vec3 out = Frame::about(normal).toWorld({sine * std::cos(turn), sine * std::sin(turn), std::sqrt(1 - sine2)});
    PatternPoint at;
    at.position = scene.toUser(mesh.positions[a] * wa + mesh.positions[b] * wb + mesh.positions[c] * wc);
    at.normal = normal, at.direction = -out, at.distance = 1;
    if (!mesh.uvs.empty()) at.uv = mesh.uvs[a] * wa + mesh.uvs[b] * wb + mesh.uvs[c] * wc;
    return at;
}

}  // namespace

float coverage(const Scene& scene, const Material& m, const Vec2& uv) {
    if (!m.hasHoles()) return 1;
    float alpha = m.alpha;
    if (const auto& slot = m.reflectanceTexture; slot.used())
        alpha *= scene.textures[static_cast<std::size_t>(slot.texture)].alpha(slot.apply(uv));
    if (m.alphaCutoff > 0) return alpha < m.alphaCutoff ? 0.0F : 1.0F;
    return alpha;
}

Rgb emittedRadiance(const Scene& scene, const Material& m, const PatternPoint& at) {
    Rgb radiance = m.emission;
    if (const auto& slot = m.emissionTexture; slot.used())
        radiance *= scene.textures[static_cast<std::size_t>(slot.texture)].sample(slot.apply(at.uv));
    if (m.emissionPattern >= 0) radiance *= scene.patterns[static_cast<std::size_t>(m.emissionPattern)]->value(at);
    return radiance;
}

float meanEmission(const Scene& scene, const Mesh& mesh, std::uint32_t triangle) {
    const auto& m = scene.materials[mesh.material];
    const float plain = luminance(m.emission, scene.weights);
    if (!m.emissionTexture.used() && m.emissionPattern < 0) return plain;
    float sum = 0;
    for (int i = 0; i < kProbes; ++i) {
        const float y = luminance(emittedRadiance(scene, m, probePoint(scene, mesh, triangle, i)), scene.weights);
        if (std::isfinite(y)) sum += y;
    }
    return (1 - kDefensive) * sum / kProbes + kDefensive * plain;
}

}  // namespace luxdeck
