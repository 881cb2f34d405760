#include "engine/transport/surface/straight.h"

#include "engine/scene/appearance.h"
#include "engine/transport/surface/glass.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// Of the material's own, holes apart.
Rgb bodyTransmittance(const Material& m, float cosine) {
    if (m.kind == MaterialKind::ThinGlass) return paneLight(m.transmittance, m.ior, cosine).transmitted;
    if (m.kind == MaterialKind::Ward && m.wardPerfect()) return m.specularTransmittance;
    return Rgb{};
}

Rgb transmittanceOf(const Scene& scene, const Material& m, const SurfacePoint& point) {
    const float cosine = std::abs(dot(point.geometricNormal, point.rayDirection));
    const Rgb body = bodyTransmittance(m, cosine);
    if (!m.hasHoles()) return body;
    const float covered = coverage(scene, m, point.uv);
    return Rgb(1 - covered) + body * covered;
}

/// The fraction of the mixture's first part; NaN where the pattern has no value.
float mixFraction(const Scene& scene, const Material& m, const SurfacePoint& point) {
    const float f = scene.patterns[static_cast<std::size_t>(m.mixPattern)]->value(point.patternPoint(scene)).r;
    return f > 1 ? 1.0F : f;
}

}  // namespace

const Material* meetMaterial(const Scene& scene, const SurfacePoint& point, float u) {
    const auto& m = *point.material;
    if (m.kind != MaterialKind::Mix) return &m;
    const float first = mixFraction(scene, m, point);
    if (!(first >= 0)) return nullptr;
    return &scene.materials[u < first ? m.mixFirst : m.mixSecond];
}

Rgb straightTransmittance(const Scene& scene, const SurfacePoint& point) {
    const auto& m = *point.material;
    if (m.kind != MaterialKind::Mix) return transmittanceOf(scene, m, point);
    const float first = mixFraction(scene, m, point);
    if (!(first >= 0)) return Rgb(std::nanf(""));
    return transmittanceOf(scene, scene.materials[m.mixFirst], point) * first +
           transmittanceOf(scene, scene.materials[m.mixSecond], point) * (1 - first);
}

}  // namespace luxdeck
