#include "engine/scene/appearance.h"
#include "engine/transport/surface/bsdf.h"
#include "engine/transport/surface/surface_point.h"
#include "engine/transport/surface/valueless.h"
#include "engine/transport/tracer/light_choice.h"
#include "engine/transport/tracer/path_batch.h"
#include "engine/transport/tracer/shadow.h"

#include <algorithm>
#include <cmath>

// What paths find: the lights that they see, those that they sought, and what a field says; and what they could not find,
// since a surface has no value or no strategy looks there.
namespace luxdeck {

namespace {

/// Light of a lamp or a field that has no value may be anything.
const Rgb kUnbounded(kInfinity);

/// How much more than an even spread of the same light a place may get from curved mirrors and solids that bend light. The
/// mean over all places is that of the even spread; by Markov's inequality at most one in twenty gets more than twenty times
/// as much. Light that a rough surface spreads once more comes from many places: three times is a stated prior.
constexpr float kUnevenStraight = 20, kUnevenSpread = 3;

/// Surfaces that a look through solids and mirrors passes at most.
constexpr int kMostPassed = 16;

RayFailure failureOf(const Rgb& c, bool mayBeNegative) {
    return !isFinite(c) ? RayFailure::NotFinite : c.min() < 0 && !mayBeNegative ? RayFailure::Negative : RayFailure::None;
}

}  // namespace

template <Spectrum S>
void PathBatch<S>::seeSky(Path& path) {
    path.ended = true;
    if (!scene_.needs.sky) return;
    // By way of a mirror next-event estimation has the suns to itself, where it looks there.
    const bool sunsFound = path.mirror != kNoMirror && !path.from.glossy;
    const Rgb radiance = skyRadiance(scene_, path.from, path.ray.direction, path.pdfSolidAngle, sunsFound ? Suns::Without : Suns::With);
    const S found = throughputAfter(path, kInfinity) * fromRgb<S>(radiance);
    noteFound(path, found);
    add(path, kFromSky, found);
}

template <Spectrum S>
void PathBatch<S>::seeOpening(const Path& path, const Hit& hit) {
    const auto& opening = scene_.lights.opening(hit.luminaire);
    const auto met = opening.intersect(path.ray.origin, path.ray.direction, 0, kInfinity);
    if (path.mirror != kNoMirror && foundByMirror(scene_, path.from, path.mirror, hit, path.ray.direction)) return;
    // The far side of a closed body faces away: what it emits there does not come this way.
    if (!met || (!opening.flat() && (dot(met->normal, path.ray.direction) >= 0 || met->distance < 0.999F * hit.distance)))
        return;
    const float pdf = path.pdfSolidAngle > 0
                          ? lampChance(scene_, path.from) * scene_.lights.pdfOpening(path.from, hit.luminaire, path.ray.direction)
                          : 0;
    const S radiance = fromRgb<S>(scene_.lights.openingRadiance(hit.luminaire, -path.ray.direction));
    const S found = throughputAfter(path, hit.distance) * radiance * weightOfDirection(path, pdf);
    noteFound(path, found);
    add(path, hit.luminaire, found);
}

template <Spectrum S>
void PathBatch<S>::seeSurface(const Path& path, const Hit& hit, const SurfacePoint& point) {
    if (!scene_.needs.meshLights) return;
    const Rgb emitted = emittedRadiance(scene_.scene, point);
    if (emitted.isBlack()) return;
    // Some emission is for the eye alone: a ray that has met nothing but mirrors and panes.
    const bool byEye = queries_[path.query].pdfSolidAngle == 0 && path.virtualOpen;
    if (!byEye && !point.material->emissionLights) return;
    const float cosine = -dot(point.geometricNormal, path.ray.direction);
    const float distance = (point.position - path.from.position).length();
    if (path.mirror != kNoMirror && foundByMirror(scene_, path.from, path.mirror, hit, cosine, distance)) return;
    const float pdf = path.pdfSolidAngle > 0
                          ? lampChance(scene_, path.from) * scene_.lights.pdfTriangle(path.from, hit.mesh, hit.triangle, distance, cosine)
                          : 0;
    const S found = path.throughput * fromRgb<S>(emitted) * weightOfDirection(path, pdf);
    noteFound(path, found);
    add(path, kFromSurfaces, found);
}

/// A part of the sample is missing, at most `lost` of it.
template <Spectrum S>
void PathBatch<S>::fail(std::uint32_t query, RayFailure failure, const Rgb& lost) {
    auto& sample = samples_[query];
    if (sample.failure == RayFailure::None) sample.failure = failure;
    sample.lost += lost;
}

/// A pattern has no value here: the surface reflects something between nothing and what the whitest would. What was found
/// so far stays; the path goes on to find how much that may be.
template <Spectrum S>
void PathBatch<S>::loseSight(Path& path, const Hit& hit, SurfacePoint& point) {
    fail(path.query, RayFailure::NotFinite, Rgb{});
    auto& sample = samples_[path.query];
    if (sample.lostAt == kNothing) sample.lostAt = scene_.scene.meshes[hit.mesh].material;
    path.lost = true;
    point.material = &valuelessMaterial();
}

/// At the first surface behind which no light is sought: how much light falls on it that a look through such surfaces
/// reaches, as if it spread that evenly.
template <Spectrum S>
void PathBatch<S>::weighUnseen(Path& path, const SurfacePoint& point) {
    if (path.lost || path.ended) return;
    path.byChance = true;
    const Receiver around{point.position, Vec3(0, 0, 0), false};
    const float uSelect = path.numbers.next1D();
    const auto light = chooseLight(scene_, around, uSelect, path.numbers.next2D());
    if (!light.lit() || !isFinite(light.weight)) return;
    const Vec3 from = point.departure(light.direction);
    if (!reaches({from, 0, light.direction, light.distance * (1 - kShadowShortening)})) return;
    const auto& weights = scene_.scene.weights;
    const float throughput = luminance(toRgb(path.throughput), weights);
    const float cosine = std::abs(dot(light.direction, point.geometricNormal));
    const float uneven = path.reflections == 0 ? kUnevenStraight : kUnevenSpread;
    auto& chance = samples_[path.query].chance;
    chance.diffused += uneven * throughput * luminance(light.weight, weights) * cosine / kPi;
    const float peak = light.pdfSolidAngle > 0 ? throughput * luminance(light.weight, weights) * light.pdfSolidAngle : kInfinity;
    chance.peak = std::max(chance.peak, peak);
}

/// Nothing but mirrors, panes and solids that bend light stands in the way.
template <Spectrum S>
bool PathBatch<S>::reaches(Ray ray) {
    for (int passed = 0; passed < kMostPassed; ++passed) {
        Hit hit;
        scene_.raycaster.closestHits({&ray, 1}, {&hit, 1}, Targets::Surfaces);
        ++counters_.rays;
        if (!hit.surface()) return true;
        const auto& material = scene_.scene.materials[scene_.scene.meshes[hit.mesh].material];
        const auto kind = material.kind;
        const bool passes = kind == MaterialKind::Mirror || kind == MaterialKind::ThinGlass || kind == MaterialKind::Dielectric ||
                            kind == MaterialKind::Mix || material.hasHoles();
        if (!passes) return false;
        ray.tMin = std::max(ray.tMin, hit.distance) * (1 + 1e-5F) + 8 * spacingAt(ray.origin);
        if (!(ray.tMin < ray.tMax)) return true;
    }
    return true;
}

template <Spectrum S>
void PathBatch<S>::noteFound(const Path& path, const S& radiance) {
    if (path.byChance && !path.lost) samples_[path.query].chance.found += luminance(toRgb(radiance), scene_.scene.weights);
}

template <Spectrum S>
void PathBatch<S>::traceMirrored() {
    for (const auto& m : mirrored_) {
        const Rgb passed = throughputByMirror(scene_, m.origin, m.path, counters_);
        if (isFinite(passed)) add(m.query, m.reflections, m.path.light.source, m.contribution * fromRgb<S>(passed), m.diffuse);
        else fail(m.query, RayFailure::NotFinite, toRgb(m.contribution));
    }
    mirrored_.clear();
}

template <Spectrum S>
void PathBatch<S>::traceShadows() {
    shadowed_.resize(shadowRays_.size());
    scene_.raycaster.occluded(shadowRays_, shadowed_, Targets::Opaque);
    counters_.rays += shadowRays_.size();
    for (std::size_t i = 0; i < shadows_.size(); ++i) {
        if (shadowed_[i] != 0) continue;
        const auto& shadow = shadows_[i];
        S contribution = shadow.contribution;
        if (scene_.needs.transmission) {
            const Rgb passed = paneTransmittance(scene_, shadowRays_[i], counters_);
            if (!isFinite(passed)) {  // a pane without a value lets through something between nothing and all
                fail(shadow.query, RayFailure::NotFinite, toRgb(contribution));
                continue;
            }
            contribution *= fromRgb<S>(passed);
        }
        add(shadow.query, shadow.reflections, shadow.source, contribution, shadow.diffuse);
    }
    shadows_.clear();
    shadowRays_.clear();
}

template <Spectrum S>
void PathBatch<S>::askField(const Path& path, const Hit& hit, const SurfacePoint& point, const Receiver& here, const S& albedo, float factor) {
    fieldPoints_.push_back({here.position, point.shadingNormal, point.geometricNormal, hit.mesh, hit.triangle, hit.u, hit.v, point.frontFace});
    fromField_.push_back({path.throughput * albedo * (factor / kPi), path.query, countedAs(path, path.reflections + 2),
                          diffusePart(path, S(1.0F), S(1.0F))});
}

template <Spectrum S>
void PathBatch<S>::takeFromField() {
    if (fieldPoints_.empty()) return;
    fieldLux_.resize(fieldPoints_.size());
    (settings_.control != nullptr ? settings_.control : settings_.field)->indirect(fieldPoints_, fieldLux_);
    for (auto& lux : fieldLux_)
        if (settings_.control != nullptr && !isFinite(lux)) lux = Rgb{};  // no word, to those that go on as to the others
    takeGaps();
    for (std::size_t i = 0; i < fieldPoints_.size(); ++i) {
        const auto& from = fromField_[i];
        add(from.query, from.reflections, kFromAmbient, from.weight * fromRgb<S>(fieldLux_[i]), from.diffuse);
        if (settings_.links != nullptr) settings_.links->push_back({fieldPoints_[i], toRgb(from.weight), from.query, from.reflections == kLost});
    }
    fieldPoints_.clear();
    fromField_.clear();
}

/// What the field lacks the sample lacks, and where that may be more than what the field has, the sample counts as failed. A
/// control may lack what it likes: what it says is taken away again.
template <Spectrum S>
void PathBatch<S>::takeGaps() {
    if (settings_.control != nullptr || !settings_.field->hasGaps()) return;
    std::vector<Rgb> gaps(fieldPoints_.size());
    settings_.field->gaps(fieldPoints_, gaps);
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        if (gaps[i].isBlack()) continue;
        const auto& from = fromField_[i];
        auto& sample = samples_[from.query];
        const Rgb missing = toRgb(from.weight * fromRgb<S>(gaps[i]));
        const bool known = isFinite(missing);
        sample.lost += known ? missing : kUnbounded;
        const bool fails = !known || gaps[i].max() > fieldLux_[i].max();
        if (fails && sample.failure == RayFailure::None) sample.failure = RayFailure::NotFinite;
    }
}

template <Spectrum S>
void PathBatch<S>::add(std::uint32_t query, int reflections, LightSource source, const S& radiance, const S& diffuse) {
    auto& sample = samples_[query];
    const auto failure = failureOf(toRgb(radiance), settings_.control != nullptr);
    if (failure != RayFailure::None) return fail(query, failure, kUnbounded);
    if (reflections == kLost) {
        sample.lost += toRgb(radiance);
        return;
    }
    if (reflections > 0 && !settings_.bounces.empty()) settings_.bounces[query].diffuse += toRgb(radiance * diffuse);
    (reflections == 0 ? sample.emitted : reflections == 1 ? sample.direct : sample.indirect) += toRgb(radiance);
    if (settings_.shares != nullptr) settings_.shares->push_back({toRgb(radiance), query, source, reflections == 0});
}

/// Defined here, called by the story of the path.
#define LUXDECK_FINDS(S)                                                                                        \
    template void PathBatch<S>::seeSky(Path&);                                                                  \
    template void PathBatch<S>::seeOpening(const Path&, const Hit&);                                            \
    template void PathBatch<S>::seeSurface(const Path&, const Hit&, const SurfacePoint&);                       \
    template void PathBatch<S>::fail(std::uint32_t, RayFailure, const Rgb&);                                    \
    template void PathBatch<S>::loseSight(Path&, const Hit&, SurfacePoint&);                                    \
    template void PathBatch<S>::weighUnseen(Path&, const SurfacePoint&);                                        \
    template void PathBatch<S>::traceMirrored();                                                                \
    template void PathBatch<S>::traceShadows();                                                                 \
    template void PathBatch<S>::askField(const Path&, const Hit&, const SurfacePoint&, const Receiver&, const S&, float); \
    template void PathBatch<S>::takeFromField();                                                                \
    template void PathBatch<S>::takeGaps();                                                                     \
    template void PathBatch<S>::add(std::uint32_t, int, LightSource, const S&, const S&);
LUXDECK_FINDS(Rgb)
LUXDECK_FINDS(Grey)

}  // namespace luxdeck
