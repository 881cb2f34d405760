#include "engine/transport/tracer/mirrored_light.h"

#include "engine/transport/surface/bsdf.h"
#include "engine/sampling/sky_sampler.h"
#include "engine/transport/surface/surface_point.h"
#include "engine/transport/tracer/shadow.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

constexpr float kUniform = 0.1F;  // part of the choices that goes to all mirrors alike

/// Where both a sun and lamps show in a mirror, the part of the choices that goes to the sun.
constexpr float kSunShare = 0.5F;

/// How far from the plane's crossing a hit still is the mirror [relative to the distance].
constexpr float kAtMirror = 1e-4F;

/// Along a direction from behind the mirror to where it crosses the mirror's plane [m]; not positive: it does not.
float toPlane(const FlatMirror& mirror, const Vec3& behind, const Vec3& direction) {
    return -(dot(mirror.normal, behind) - mirror.offset) / dot(mirror.normal, direction);
}

/// Whether a part of the sun may show in the mirror, seen from behind it.
bool shows(const FlatMirror& mirror, const Vec3& behind, const Sun& sun) {
    const float distance = toPlane(mirror, behind, sun.direction);
    if (!(distance > 0 && distance < kInfinity)) return false;
    const Vec3 crossing = behind + sun.direction * distance - mirror.frame.centre;
    // The disc is an ellipse on the mirror, longer the more it grazes.
    const float slope = std::max(std::abs(dot(mirror.normal, sun.direction)), 1e-3F);
    const float blur = 2 * distance * static_cast<float>(std::tan(std::min(sun.halfAngleRad, 1.5))) / slope + 64 * spacingAt(behind);
    return std::abs(dot(crossing, mirror.frame.u)) <= mirror.frame.halfU + blur &&
           std::abs(dot(crossing, mirror.frame.v)) <= mirror.frame.halfV + blur;
}

/// The suns that may show, of those there are; all are few.
std::vector<const Sun*> sunsIn(const TransportScene& scene, const FlatMirror& mirror, const Vec3& behind) {
    std::vector<const Sun*> found;
    for (const auto& sun : scene.scene.sky.suns)
        if (shows(mirror, behind, sun)) found.push_back(&sun);
    return found;
}

/// One of the suns, evenly, and a direction within its disc.
LightSample aimAtSun(const std::vector<const Sun*>& suns, float share, float u, Vec2 uDisc) {
    const auto count = static_cast<float>(suns.size());
    const auto& sun = *suns[std::min(static_cast<std::size_t>(u * count), suns.size() - 1)];
    const double s = std::sin(sun.halfAngleRad / 2), below = 2 * s * s * uDisc.x;  // 1 - cos, without cancellation
    const double sine = std::sqrt(below * (2 - below)), azimuth = 2 * kPiD * uDisc.y;
    LightSample out;
    out.direction = Frame::about(sun.direction).toWorld(Vec3(Vec3d(sine * std::cos(azimuth), sine * std::sin(azimuth), 1 - below)));
    out.distance = kInfinity;
    out.pdfSolidAngle = share / (count * static_cast<float>(sun.solidAngle()));
    out.weight = sun.radiance * (1 / out.pdfSolidAngle);
    return out;
}

}  // namespace

bool seeksByMirrors(const TransportScene& scene) {
    return !scene.mirrors.empty() && (!scene.lights.empty() || (scene.sky != nullptr && !scene.scene.sky.suns.empty()));
}

std::optional<MirrorPath> aimByMirror(const TransportScene& scene, const Receiver& at, std::uint32_t index, const LightSampler::Weights& weights,
                                      float uSelect, Vec2 u) {
    const auto& mirror = scene.mirrors.all()[index];
    const auto behind = mirror.mirrored(at);
    MirrorPath path;
    const auto suns = scene.sky != nullptr ? sunsIn(scene, mirror, behind.position) : std::vector<const Sun*>{};
    const float sunShare = suns.empty() ? 0.0F : scene.lights.empty() ? 1.0F : kSunShare;
    if (uSelect < sunShare) {
        path.light = aimAtSun(suns, sunShare, uSelect / sunShare, u);
    } else {
        if (scene.lights.empty()) return std::nullopt;
        path.light = scene.lights.sample(behind, weights, std::min((uSelect - sunShare) / (1 - sunShare), 0x1.fffffep-1F), u);
        if (!path.light.lit() || path.light.shared || path.light.source == kFromSky) return std::nullopt;
        path.light.weight *= 1 / (1 - sunShare);
    }
    // The line from behind to the light crosses the plane once; the light must lie on the receiver's side.
    path.toMirror = toPlane(mirror, behind.position, path.light.direction);
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
        const auto behind = mirror.mirrored(at);
        weights_.push_back(scene.lights.weighThrough(behind, mirror.frame));
        chances_.push_back(std::max(weights_.back().few.back(), 0.0F));
        if (scene.sky == nullptr) continue;
        for (const auto* sun : sunsIn(scene, mirror, behind.position))
            chances_.back() += luminance(sun->radiance, scene.scene.weights) * static_cast<float>(sun->solidAngle());
    }
    for (const float chance : chances_) sum += chance;
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
