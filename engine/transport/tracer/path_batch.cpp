#include "engine/transport/tracer/path_batch.h"

#include "engine/scene/appearance.h"
#include "engine/transport/surface/bsdf.h"
#include "engine/transport/surface/straight.h"
#include "engine/transport/surface/surface_point.h"
#include "engine/transport/tracer/light_choice.h"
#include "engine/transport/tracer/shadow.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// Of the matte vertices, those that look for lights in mirrors.
constexpr float kMirrorShare = 0.25F;

}  // namespace

template <Spectrum S>
PathBatch<S>::PathBatch(const TransportScene& scene, const TracerSettings& settings,
                        std::span<const RadianceQuery> queries, std::span<RadianceSample> samples)
    : scene_(scene), settings_(settings), byMirrors_(seeksByMirrors(scene)), queries_(queries), samples_(samples), paths_(queries.size()) {
    for (std::uint32_t i = 0; i < queries.size(); ++i) {
        samples[i] = RadianceSample{};
        auto& path = paths_[i];
        path.ray = queries[i].ray;
        path.numbers = queries[i].numbers;
        path.query = i;
        path.from = queries[i].origin;
        path.pdfSolidAngle = queries[i].pdfSolidAngle;
        path.mostReflections = settings.maxReflections;
    }
    findMedia();
    rays_.reserve(queries.size()), hits_.reserve(queries.size()), shadows_.reserve(queries.size());
    shadowRays_.reserve(queries.size()), shadowed_.reserve(queries.size());
    counters_.paths = queries.size();
}

template <Spectrum S>
void PathBatch<S>::findMedia() {
    if (!scene_.needs.dielectrics) return;
    MediaFinder finder(scene_);
    media_.reserve(queries_.size());
    for (const auto& query : queries_)
        media_.push_back(isGood(query.ray) ? finder.at(query.ray.origin, counters_) : Media{});
}

template <Spectrum S>
TransportCounters PathBatch<S>::run() {
    while (!paths_.empty()) {
        trace();
        for (std::size_t i = 0; i < paths_.size(); ++i) shade(i);
        traceShadows();
        traceMirrored();
        takeFromField();
        removeEnded();
    }
    return finish();
}

template <Spectrum S>
void PathBatch<S>::trace() {
    rays_.clear();
    for (const auto& path : paths_) rays_.push_back(path.ray);
    hits_.resize(paths_.size());
    const bool openings = scene_.needs.luminaireSurfaces;
    scene_.raycaster.closestHits(rays_, hits_, openings ? Targets::Everything : Targets::Surfaces);
    counters_.rays += rays_.size();
    if (!openings) return;
    for (std::size_t i = 0; i < paths_.size(); ++i)
        if (hits_[i].opening()) passOpenings(i);
}

/// Openings give light and hide nothing: the ray goes on to what lies behind.
template <Spectrum S>
void PathBatch<S>::passOpenings(std::size_t i) {
    Ray ray = rays_[i];
    while (hits_[i].opening()) {
        seeOpening(paths_[i], hits_[i]);
        // Past it for certain: where the ray grazes it, the distance found again may round either way.
        ray.tMin = std::max(ray.tMin, hits_[i].distance) * (1 + 1e-6F) + 1e-7F;
        scene_.raycaster.closestHits({&ray, 1}, {&hits_[i], 1}, Targets::Everything);
        ++counters_.rays;
    }
}

template <Spectrum S>
void PathBatch<S>::shade(std::size_t i) {
    auto& path = paths_[i];
    const auto& hit = hits_[i];
    if (hit.badRay) {
        fail(path.query, RayFailure::BadRay, Rgb(kInfinity));
        path.ended = true;
        return;
    }
    if (!hit.surface()) {
        seeSky(path);
        return;
    }
    auto point = surfacePoint(scene_.scene, scene_.needs, path.ray, hit);
    path.throughput = throughputAfter(path, hit.distance);
    if (meets(path, hit, point)) shadeMet(path, hit, point);
    ++path.vertices;
    if (!path.ended) roulette(path);
}

/// Settles what a mixture is for this path, and whether it goes through a hole.
template <Spectrum S>
bool PathBatch<S>::meets(Path& path, const Hit& hit, SurfacePoint& point) {
    if (scene_.needs.patterns && point.material->kind == MaterialKind::Mix) {
        point.material = meetMaterial(scene_.scene, point, path.numbers.next1D());
        if (point.material == nullptr) loseSight(path, hit, point);
    }
    if (!scene_.needs.alpha || !point.material->hasHoles()) return true;
    if (path.numbers.next1D() < coverage(scene_.scene, *point.material, point.uv)) return true;
    recordVirtual(path, hit.distance, true);
    path.straight = false;
    goStraightOn(path, point);
    return false;
}

template <Spectrum S>
void PathBatch<S>::shadeMet(Path& path, const Hit& hit, const SurfacePoint& point) {
    if (samples_[path.query].object == kNothing) recordFirst(path, hit, point);
    seeSurface(path, hit, point);
    const bool last = path.reflections >= path.mostReflections;
    if (last && !scene_.needs.transmission && !scene_.needs.dielectrics) {
        path.ended = true;
        return;
    }
    const auto& needs = scene_.needs;
    const Bsdf<S> bsdf(scene_.scene, needs, point, needs.dielectrics ? surroundingIor(path, point) : 1.0F);
    if (!bsdf.valid()) {
        auto white = point;
        loseSight(path, hit, white);
        return shadeMet(path, hit, white);
    }
    recordVirtual(path, hit.distance, bsdf.keepsImages());
    if (last && !bsdf.letsThrough()) path.ended = true;
    else if (!bsdf.specular()) scatterRough(path, hit, point, bsdf, last);
    else if (point.material->kind == MaterialKind::Dielectric) scatterBoundary(path, point, bsdf);
    else scatterSpecular(path, hit, point, bsdf);
    if (path.reflections > path.mostReflections) path.ended = true;
}

template <Spectrum S>
void PathBatch<S>::goStraightOn(Path& path, const SurfacePoint& point) {
    path.ray = {point.departure(path.ray.direction), 0, path.ray.direction, kInfinity};
}

template <Spectrum S>
S PathBatch<S>::throughputAfter(const Path& path, float distance) const {
    if (!scene_.needs.dielectrics || media_[path.query].inAir()) return path.throughput;
    return path.throughput * fromRgb<S>(media_[path.query].transmittance(distance));
}

template <Spectrum S>
float PathBatch<S>::surroundingIor(const Path& path, const SurfacePoint& point) const {
    const auto& media = media_[path.query];
    return point.frontFace ? media.ior() : media.iorAround(*point.material);
}

template <Spectrum S>
void PathBatch<S>::recordFirst(const Path& path, const Hit& hit, const SurfacePoint& point) {
    auto& sample = samples_[path.query];
    sample.distance = hit.distance;
    sample.normal = point.geometricNormal;
    sample.object = scene_.scene.meshes[hit.mesh].object;
    sample.backFace = !point.frontFace;
}

template <Spectrum S>
void PathBatch<S>::recordVirtual(Path& path, float distance, bool specular) {
    if (!path.virtualOpen) return;
    path.travelled += distance;
    if (specular) return;
    samples_[path.query].virtualDistance = path.travelled;
    path.virtualOpen = false;
}

template <Spectrum S>
template <class B>
void PathBatch<S>::scatterSpecular(Path& path, const Hit& hit, const SurfacePoint& point, const B& bsdf) {
    const auto frame = Frame::about(point.shadingNormal);
    const auto next = bsdf.sample(frame.toLocal(-path.ray.direction), path.numbers.next1D(), {0.5F, 0.5F});
    const bool fromRough = path.pdfSolidAngle > 0, wasSought = fromRough || path.mirror != kNoMirror;
    const Vec3 direction = next.passedThrough ? path.ray.direction : frame.toWorld(next.wi);
    const bool leaves = next.passedThrough || dot(direction, point.geometricNormal) > 0;
    path.throughput *= next.weight;
    path.straight = path.straight && next.passedThrough && point.material->kind == MaterialKind::ThinGlass;
    if (path.straight) path.passed *= next.weight;
    path.ended = !leaves || path.throughput.isBlack();
    path.ray = {point.departure(direction), 0, direction, kInfinity};
    if (next.passedThrough) return;  // straight on: next-event estimation saw through the pane as well
    path.mirror = fromRough ? scene_.mirrors.of(hit.mesh, hit.triangle) : kNoMirror;
    if (wasSought && path.mirror == kNoMirror) weighUnseen(path, point);
    ++path.reflections;
    path.pdfSolidAngle = 0;
}

/// Into a solid or out of it, or back. Radiance was found by no other strategy: shadow rays do not bend.
template <Spectrum S>
template <class B>
void PathBatch<S>::scatterBoundary(Path& path, const SurfacePoint& point, const B& bsdf) {
    const float u = path.numbers.next1D();
    ScatterSample<S> next;
    Vec3 direction;
    // An interpolated normal may bend a direction to the wrong side of the triangle; its own cannot.
    for (const auto& normal : {point.shadingNormal, point.geometricNormal}) {
        const auto frame = Frame::about(normal);
        next = bsdf.sample(frame.toLocal(-path.ray.direction), u, {0.5F, 0.5F});
        direction = frame.toWorld(next.wi);
        if ((dot(direction, point.geometricNormal) < 0) == next.refracted) break;
    }
    if (path.pdfSolidAngle > 0 || path.mirror != kNoMirror) weighUnseen(path, point);
    path.throughput *= next.weight;
    path.ray = {point.departure(direction), 0, direction, kInfinity};
    path.pdfSolidAngle = 0;
    path.mirror = kNoMirror;
    path.straight = false;
    auto& media = media_[path.query];
    if (!next.refracted) ++path.reflections;
    else if (!point.frontFace) media.leave(*point.material);
    else if (!media.enter(*point.material)) truncate(path);
}

/// No pattern, which may change with the direction, decides what the surface is, and no medium dims it by distance.
template <Spectrum S>
bool PathBatch<S>::looksAlike(const Path& path, const Hit& hit, const SurfacePoint& point) const {
    if (path.lost || (scene_.needs.dielectrics && !media_[path.query].inAir())) return false;
    const auto& ofMesh = scene_.scene.materials[scene_.scene.meshes[hit.mesh].material];  // another than the point's in a mixture
    return !scene_.needs.patterns || (point.material->reflectancePattern < 0 && point.material == &ofMesh);
}

/// Others share what is found beyond a matte first bounce: fewer paths need to go on.
template <Spectrum S>
void PathBatch<S>::thinOut(Path& path, const SurfacePoint& point) {
    if (settings_.goesOn >= 1 || settings_.control != nullptr || point.material->kind != MaterialKind::Matte) return;
    path.ended = path.numbers.next1D() >= settings_.goesOn;
    path.throughput *= 1 / settings_.goesOn;
}

/// The part of light scattered here that leaves alike in all directions, where this is the first bounce.
template <Spectrum S>
S PathBatch<S>::diffusePart(const Path& path, const S& diffuse, const S& all) const {
    return atFirstBounce(path) ? partOf(diffuse, all) : path.diffuse;
}

template <Spectrum S>
template <class B>
void PathBatch<S>::scatterRough(Path& path, const Hit& hit, const SurfacePoint& point, const B& bsdf, bool last) {
    const auto frame = scene_.needs.glossy ? surfaceFrame(scene_.scene, point, hit) : Frame::about(point.shadingNormal);
    const Vec3 wo = frame.toLocal(-path.ray.direction);
    // Light from behind must not be weighed away where it is scattered through.
    const Receiver here{point.departure(point.geometricNormal), bsdf.transmits() ? Vec3(0, 0, 0) : point.shadingNormal,
                        point.material->kind != MaterialKind::Matte};
    if (atFirstBounce(path) && looksAlike(path, hit, point)) {
        settings_.bounces[path.query] = {true, here.position, point.geometricNormal, point.shadingNormal, hit, bsdf.coated(),
                                         path.vertices > 0, toRgb(path.passed), {}};
        thinOut(path, point);
        if (path.ended) return;
    }
    if (!last && !settings_.ambientRadiance.isBlack())
        add(path.query, countedAs(path, 2), kFromAmbient, path.throughput * bsdf.albedo(wo.z) * fromRgb<S>(settings_.ambientRadiance), S(0.0F));
    const bool asks = !last && settings_.field != nullptr && path.reflections >= settings_.fieldAfter && point.material->kind == MaterialKind::Matte;
    if (asks) askField(path, hit, point, here, bsdf.albedo(wo.z), 1), path.mostReflections = path.reflections + 1;
    if (!last) connectLight(path, here, point, frame, wo, bsdf);
    if (!last && path.reflections + 1 < path.mostReflections && byMirrors_)
        connectByMirror(path, here, point, frame, wo, bsdf);
    if (!goesBeyondControl(path, hit, point, here, bsdf.albedo(wo.z))) return;
    scatter(path, here, point, frame, wo, bsdf);
    path.straight = false;
}

/// Looks for a light in a mirror or pane, at some of the vertices, which count for all.
template <Spectrum S>
template <class B>
void PathBatch<S>::connectByMirror(Path& path, const Receiver& here, const SurfacePoint& point, const Frame& frame, const Vec3& wo,
                                   const B& bsdf) {
    if (here.glossy || path.numbers.next1D() >= kMirrorShare) return;
    const auto choice = scene_.mirrors.choose(path.numbers.next1D());
    const auto& mirror = scene_.mirrors.all()[choice.mirror];
    const auto weights = scene_.lights.weighThrough(mirror.mirrored(here), mirror.frame);
    const float uSelect = path.numbers.next1D();
    const auto found = aimByMirror(scene_, here, choice.mirror, weights, uSelect, path.numbers.next2D());
    if (!found || dot(found->direction, point.geometricNormal) <= 0) return;
    const auto value = bsdf.evaluate(wo, frame.toLocal(found->direction));
    const S contribution = path.throughput * value.cosineWeighted * fromRgb<S>(found->light.weight) * (1 / (kMirrorShare * choice.probability));
    if (!contribution.isBlack())
        mirrored_.push_back({*found, contribution, here.position, path.query, countedAs(path, path.reflections + 2),
                             diffusePart(path, value.diffuse, value.cosineWeighted)});
}

template <Spectrum S>
template <class B>
void PathBatch<S>::connectLight(Path& path, const Receiver& here, const SurfacePoint& point, const Frame& frame,
                                const Vec3& wo, const B& bsdf) {
    const float uSelect = path.numbers.next1D();
    const auto light = chooseLight(scene_, here, uSelect, path.numbers.next2D());
    if (!light.lit()) return;
    const float height = dot(light.direction, point.geometricNormal);
    if (height <= 0 && !bsdf.transmits()) return;
    const Vec3 wi = frame.toLocal(light.direction);
    if (height * wi.z <= 0) return;  // an interpolated normal and the triangle's own disagree on the side
    const auto value = bsdf.evaluate(wo, wi);
    S contribution = throughputAfter(path, light.distance) * value.cosineWeighted * fromRgb<S>(light.weight);
    if (light.shared) contribution *= light.pdfSolidAngle / (light.pdfSolidAngle + value.pdf);
    if (contribution.isBlack()) return;
    shadows_.push_back({contribution, path.query, countedAs(path, path.reflections + 1), light.source,
                        diffusePart(path, value.diffuse, value.cosineWeighted)});
    const Vec3 origin = height > 0 ? here.position : point.departure(light.direction);
    shadowRays_.push_back({origin, 0, light.direction, light.distance * (1 - kShadowShortening)});
}

template <Spectrum S>
template <class B>
void PathBatch<S>::scatter(Path& path, const Receiver& here, const SurfacePoint& point, const Frame& frame,
                           const Vec3& wo, const B& bsdf) {
    const float uLobe = scene_.needs.glossy ? path.numbers.next1D() : 0;
    const auto next = bsdf.sample(wo, uLobe, path.numbers.next2D());
    const Vec3 direction = frame.toWorld(next.wi);
    path.throughput *= next.weight;
    path.diffuse = diffusePart(path, next.diffuse, next.weight);
    path.ended = next.absorbed || path.throughput.isBlack();
    if (next.passedThrough) return goStraightOn(path, point);  // as through a pane
    const float height = dot(direction, point.geometricNormal);
    path.ended |= height * next.wi.z <= 0;
    path.from = here;
    path.ray = {height > 0 ? here.position : point.departure(direction), 0, direction, kInfinity};
    path.pdfSolidAngle = next.pdf;
    path.mirror = kNoMirror;
    path.byChance = false;
    ++path.reflections;
    const auto& needs = scene_.needs;
    const bool canSeeLight = needs.sky || needs.meshLights || needs.luminaireSurfaces;
    if (path.reflections >= path.mostReflections && !canSeeLight) path.ended = true;
}

/// Ends a path with the chance that its throughput has fallen to: what survives counts the more, so that
/// the mean is exact. The cap is a truncation, and counted as one.
template <Spectrum S>
void PathBatch<S>::roulette(Path& path) {
    if (path.vertices >= settings_.maxVertices) {
        truncate(path);
        return;
    }
    // In a solid radiance is larger by its squared index of refraction, which is no reason to live longer or less.
    const float ior = scene_.needs.dielectrics ? media_[path.query].ior() : 1.0F;
    // Never less than that: weights would grow without bound, and the variance with them. What mirrors pass on without
    // loss the cap ends.
    const float survival = path.throughput.max() * ior * ior;
    if (survival >= 1) return;
    if (path.numbers.next1D() >= survival) path.ended = true;
    else path.throughput *= 1 / survival;
}

template <Spectrum S>
void PathBatch<S>::truncate(Path& path) {
    path.ended = true;
    ++counters_.truncated;
    counters_.truncatedWeight += path.throughput.max();
}

/// The field's word is a control variate: what it adds to the paths that go on and to those that do not is zero in the mean.
template <Spectrum S>
bool PathBatch<S>::goesBeyondControl(Path& path, const Hit& hit, const SurfacePoint& point, const Receiver& here, const S& albedo) {
    const bool controlled = settings_.control != nullptr && path.straight && settings_.bounces[path.query].met;
    if (!controlled || point.material->kind != MaterialKind::Matte) return true;
    path.ended = path.numbers.next1D() >= settings_.goesOn;
    const float kept = path.ended ? 0 : 1 / settings_.goesOn;
    askField(path, hit, point, here, albedo, settings_.controlWeight * (1 - kept));
    path.throughput *= kept;
    return !path.ended;
}

template <Spectrum S>
void PathBatch<S>::removeEnded() {
    std::erase_if(paths_, [](const Path& path) { return path.ended; });
}

template <Spectrum S>
TransportCounters PathBatch<S>::finish() {
    for (std::uint32_t query = 0; query < samples_.size(); ++query) {
        auto& sample = samples_[query];
        for (auto* part : {&sample.emitted, &sample.direct, &sample.indirect}) {
            if (isFinite(*part)) continue;  // finite contributions may still add up to more than a float holds
            fail(query, RayFailure::NotFinite, Rgb(kInfinity));
            *part = Rgb{};
        }
        if (sample.failure != RayFailure::None) ++counters_.rejected;
    }
    return counters_;
}

template Rgb PathBatch<Rgb>::diffusePart(const Path&, const Rgb&, const Rgb&) const;
template Grey PathBatch<Grey>::diffusePart(const Path&, const Grey&, const Grey&) const;

TransportCounters tracePaths(const TransportScene& scene, const TracerSettings& settings,
                             std::span<const RadianceQuery> queries, std::span<RadianceSample> samples) {
    return scene.needs.colour ? PathBatch<Rgb>(scene, settings, queries, samples).run()
                              : PathBatch<Grey>(scene, settings, queries, samples).run();
}

}  // namespace luxdeck
