#include "engine/transport/tracer/mirrored_light.h"

#include "engine/transport/surface/bsdf.h"
#include "engine/transport/tracer/shadow.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

constexpr float kUniform = 0.1F;  // part of the choices that goes to all mirrors alike

/// How far from the plane's crossing a hit still is the mirror [relative to the distance].
constexpr float kAtMirror = 1e-4F;

}  // namespace

std::optional<MirrorPath> aimByMirror(const TransportScene& scene, const Receiver& at, std::uint32_t index, const LightSampler::Weights& weights,
                                      float uSelect, Vec2 u) {
    const auto& mirror = scene.mirrors.all()[index];
    const auto behind = mirror.mirrored(at);
    MirrorPath path;
    path.light = scene.lights.sample(behind, weights, uSelect, u);
    if (!path.light.lit() || path.light.shared || path.light.source == kFromSky) return std::nullopt;
    // The line from behind to the light crosses the plane once; the light must lie on the receiver's side.
    const float height = dot(mirror.normal, behind.position) - mirror.offset;
    const float slope = dot(mirror.normal, path.light.direction);
    path.toMirror = -height / slope;
    path.toLight = path.light.distance;
    if (!(path.toMirror > 0 && path.toMirror < path.toLight)) return std::nullopt;
    path.mirror = index;
    path.direction = mirror.turned(path.light.direction);
    return path;
}

Rgb throughputByMirror(const TransportScene& scene, const Vec3& origin, const MirrorPath& path, TransportCounters& counters) {
    const float slack = std::max(kAtMirror * path.toMirror, 64 * spacingAt(origin));
    const Ray probe{origin, std::max(0.0F, path.toMirror - slack), path.direction, path.toMirror + slack};
    Hit hit;
    scene.raycaster.closestHits({&probe, 1}, {&hit, 1}, Targets::Surfaces);
    ++counters.rays;
    if (!hit.surface() || scene.mirrors.of(hit.mesh, hit.triangle) != path.mirror) return Rgb{};
    const auto point = surfacePoint(scene.scene, scene.needs, probe, hit);
    const Vec3 onwards = path.light.direction;
    const Ray legs[2] = {{origin, 0, path.direction, probe.tMin},
                         {point.departure(onwards), 0, onwards, (path.toLight - path.toMirror) * (1 - kShadowShortening)}};
    std::uint8_t blocked[2] = {0, 0};
    scene.raycaster.occluded(legs, blocked, Targets::Opaque);
    counters.rays += 2;
    if (blocked[0] != 0 || blocked[1] != 0) return Rgb{};
    const Bsdf<Rgb> bsdf(scene.scene, scene.needs, point);
    Rgb throughput = bsdf.albedo(std::abs(dot(path.direction, point.geometricNormal)));
    if (scene.needs.transmission)
        for (const auto& leg : legs) throughput *= paneTransmittance(scene, leg, counters);
    return throughput;
}

MirrorTable::MirrorTable(const TransportScene& scene, const Receiver& at) {
    const auto& mirrors = scene.mirrors.all();
    float sum = 0;
    for (const auto& mirror : mirrors) {
        weights_.push_back(scene.lights.weighThrough(mirror.mirrored(at), mirror.frame));
        chances_.push_back(std::max(weights_.back().few.back(), 0.0F));
        sum += chances_.back();
    }
    const float even = 1.0F / static_cast<float>(mirrors.size());
    for (auto& chance : chances_) chance = sum > 0 ? (1 - kUniform) * chance / sum + kUniform * even : even;
}

MirrorTable::Choice MirrorTable::choose(float& u) const {
    std::uint32_t m = 0;
    while (m + 1 < chances_.size() && u >= chances_[m]) u -= chances_[m++];
    u = std::min(u / chances_[m], 0x1.fffffep-1F);
    return {m, chances_[m], &weights_[m]};
}

}  // namespace luxdeck
