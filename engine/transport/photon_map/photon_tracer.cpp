#include "engine/transport/photon_map/photon_tracer.h"

#include "engine/scene/appearance.h"
#include "engine/transport/surface/bsdf.h"
#include "engine/transport/surface/straight.h"
#include "engine/transport/surface/valueless.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// Cosines to an interpolated normal are not taken below it, where a photon's weight would grow without bound.
constexpr float kLeastCosine = 0.01F;

float cosine(const Vec3& a, const Vec3& normal) { return std::max(std::abs(dot(a, normal)), kLeastCosine); }

/// What an interpolated normal makes of the light that arrives: surfaces weigh by it, but light falls on the triangle.
float arrivalFactor(const SurfacePoint& point, const Vec3& direction) {
    return cosine(direction, point.shadingNormal) / cosine(direction, point.geometricNormal);
}

void goOn(const SurfacePoint& point, const Vec3& direction, Ray& ray) { ray = {point.departure(direction), 0, direction, kInfinity}; }

}  // namespace

PhotonTracer::Arrived PhotonTracer::trace(std::uint32_t first, std::uint32_t count) const {
    Arrived arrived;
    std::vector<Photon> photons(count);
    MediaFinder media(scene_);
    for (std::uint32_t i = 0; i < count; ++i) {
        auto& photon = photons[i];
        SamplePath numbers(seed_, first + i);
        const auto emitted = emission_.emit(numbers);
        photon.random = RandomStream(streamSeed(seed_, first + i));
        photon.ray = emitted.ray, photon.power = emitted.power, photon.fromPoint = emitted.fromPoint;
        if (!isFinite(photon.power)) loseLight(photon, arrived);
        else if (photon.power.isBlack()) photon.ended = true;
        if (scene_.needs.dielectrics && !photon.ended) photon.media = media.at(photon.ray.origin, arrived.counters);
    }
    arrived.counters.paths = count;
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    while (true) {
        std::erase_if(photons, [](const Photon& p) { return p.ended; });
        if (photons.empty()) return arrived;
        rays.clear();
        for (const auto& photon : photons) rays.push_back(photon.ray);
        hits.resize(rays.size());
        scene_.raycaster.closestHits(rays, hits, Targets::Surfaces);
        arrived.counters.rays += rays.size();
        for (std::size_t i = 0; i < photons.size(); ++i) meet(photons[i], hits[i], arrived);
    }
}

/// The light goes on as from the whitest surface, to tell how much may be missing; what arrived before stays.
void PhotonTracer::loseSight(Photon& photon, SurfacePoint& point, Arrived& arrived) {
    if (!photon.lost) ++arrived.counters.rejected;
    photon.lost = true;
    point.material = &valuelessMaterial();
}

void PhotonTracer::loseLight(Photon& photon, Arrived& arrived) {
    photon.ended = arrived.unbounded = true;
    ++arrived.counters.rejected;
}

void PhotonTracer::meet(Photon& photon, const Hit& hit, Arrived& arrived) const {
    if (hit.badRay) return loseLight(photon, arrived);
    if (!hit.surface()) {
        photon.ended = true;
        return;
    }
    if (++photon.vertices > maxVertices_) {
        photon.ended = true;
        ++arrived.counters.truncated;
        return;
    }
    auto point = surfacePoint(scene_.scene, scene_.needs, photon.ray, hit);
    if (scene_.needs.dielectrics && !photon.media.inAir()) photon.power *= photon.media.transmittance(hit.distance);
    if (scene_.needs.patterns && point.material->kind == MaterialKind::Mix) {
        point.material = meetMaterial(scene_.scene, point, next1D(photon));
        if (point.material == nullptr) loseSight(photon, point, arrived);
    }
    if (scene_.needs.alpha && point.material->hasHoles() && next1D(photon) >= coverage(scene_.scene, *point.material, point.uv))
        return goOn(point, photon.ray.direction, photon.ray);
    if (point.material->kind == MaterialKind::Matte && (photon.reflected || photon.bent)) deposit(photon, hit, point, arrived);
    scatter(photon, hit, point, arrived);
}

void PhotonTracer::deposit(const Photon& photon, const Hit& hit, const SurfacePoint& point, Arrived& arrived) const {
    const auto element = elements_.at(hit.mesh, hit.triangle, hit.u, hit.v, point.frontFace);
    if (element != SurfaceElements::kNone) arrived.deposits.push_back({element, photon.power * arrivalFactor(point, photon.ray.direction), photon.lost});
}

/// By the density that radiance is sampled with, the surfaces being reciprocal; only what an interpolated normal and a
/// boundary do to light is not what they do to radiance. Ends by roulette what has lost power.
void PhotonTracer::scatter(Photon& photon, const Hit& hit, const SurfacePoint& point, Arrived& arrived) const {
    const bool boundary = point.material->kind == MaterialKind::Dielectric;
    const float around = boundary ? (point.frontFace ? photon.media.ior() : photon.media.iorAround(*point.material)) : 1.0F;
    const Bsdf<Rgb> bsdf(scene_.scene, scene_.needs, point, around);
    if (!bsdf.valid()) {
        auto white = point;
        loseSight(photon, white, arrived);
        return scatter(photon, hit, white, arrived);
    }
    const auto frame = scene_.needs.glossy ? surfaceFrame(scene_.scene, point, hit) : Frame::about(point.shadingNormal);
    const Vec3 wo = frame.toLocal(-photon.ray.direction);
    const float uLobe = scene_.needs.glossy ? next1D(photon) : 0;
    const float u = next1D(photon), v = next1D(photon);
    const auto next = bsdf.sample(wo, uLobe, {u, v});
    const Vec3 direction = next.passedThrough ? photon.ray.direction : frame.toWorld(next.wi);
    const bool onItsSide = next.passedThrough || dot(direction, point.geometricNormal) * next.wi.z > 0;
    if (next.absorbed || !onItsSide) {
        photon.ended = true;
        return;
    }
    const float before = photon.power.max();
    if (!boundary) photon.power *= next.weight;
    if (!bsdf.specular() && !next.passedThrough)
        photon.power *= arrivalFactor(point, photon.ray.direction) * (std::abs(dot(direction, point.geometricNormal)) / cosine(direction, point.shadingNormal));
    if (next.refracted) {
        photon.bent = photon.fromPoint;
        if (!point.frontFace) photon.media.leave(*point.material);
        else if (!photon.media.enter(*point.material)) photon.ended = true, ++arrived.counters.truncated;
    } else if (!next.passedThrough) {
        photon.reflected = true;
    }
    goOn(point, direction, photon.ray);
    const float survival = photon.power.max() / before;
    if (survival >= 1) return;
    if (!(survival > 0) || next1D(photon) >= survival) photon.ended = true;
    else photon.power *= 1 / survival;
}

}  // namespace luxdeck
