#include "engine/volume/vertex_sampler.h"

#include "engine/core/rng.h"
#include "engine/transport/surface/surface_point.h"
#include "engine/transport/tracer/light_choice.h"
#include "engine/transport/tracer/media.h"
#include "engine/transport/tracer/mirrored_light.h"
#include "engine/transport/tracer/shadow.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace luxdeck {

namespace {

constexpr std::uint64_t kLights = 0x11, kMirrors = 0x22;  // purposes of random streams
constexpr float kOnSurfaceM = 2e-4F;                   // nearer than that a vertex lies on it
// A lamp by way of a mirror is dimmer than the lamp: an eighth of the shadow rays go there.
constexpr std::uint32_t kRaysForEachMirrored = 8;

/// Source rays of about the same direction become one, in the order of their bins: irradiance stays what it was for every
/// surface that has all of them above its horizon.
void mergeByBin(std::vector<SourceRay>& rays, const DirectionBins& bins, const LuminanceWeights& weights) {
    const auto keyOf = [&](const SourceRay& ray) { return 2 * bins.binOf(ray.direction.normalized()) + (ray.direct ? 0 : 1); };
    std::vector<std::pair<int, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < rays.size(); ++i) order.emplace_back(keyOf(rays[i]), i);
    std::sort(order.begin(), order.end());
    std::vector<SourceRay> merged;
    for (std::size_t first = 0; first < order.size();) {
        Vec3d vector(0, 0, 0);
        double lux = 0;
        SourceRay sum = rays[order[first].second];
        sum.lux = Rgb{};
        std::size_t i = first;
        for (; i < order.size() && order[i].first == order[first].first; ++i) {
            const auto& ray = rays[order[i].second];
            const double y = luminance(ray.lux, weights);
            vector += Vec3d(ray.direction) * y, lux += y;
            sum.lux += ray.lux;
        }
        first = i;
        if (lux > 0) sum.direction = Vec3(vector / lux);
        if (lux > 0 && sum.direction.length2() > 0) merged.push_back(sum);
    }
    rays = std::move(merged);
}

}  // namespace

std::uint64_t placeHash(const Vec3& p) {
    std::uint64_t h = 0;
    for (int axis = 0; axis < 3; ++axis) h = mix64(h ^ std::bit_cast<std::uint32_t>(p[axis] + 0.0F) ^ 0x9e3779b97f4a7c15ULL * static_cast<unsigned>(axis + 1));
    return h;
}

VertexState stateOf(const IrradianceVolume& volume, std::size_t vertex) {
    VertexState state;
    state.quality = volume.quality[vertex];
    if (state.quality.samples == 0) return state;
    const auto direct = volume.directAt(vertex), indirect = volume.indirectAt(vertex);
    state.direct.assign(direct.begin(), direct.end()), state.indirect.assign(indirect.begin(), indirect.end());
    state.sources = volume.sources[vertex];
    return state;
}

VertexSampler::VertexSampler(const TransportScene& scene, const RadianceEstimator& estimator, const VolumeSettings& settings, std::uint64_t seed)
    : scene_(scene), estimator_(&estimator), settings_(settings), bins_(settings.side), seed_(seed) {
    for (int bin = 0; bin < bins_.count(); ++bin) centres_.push_back(bins_.centre(bin));
}

Result<VertexSampler> VertexSampler::create(const TransportScene& scene, const RadianceEstimator& estimator, const VolumeSettings& settings,
                                            std::uint64_t seed) {
    if (settings.side < 2 || settings.side > 64)
        return Error{ErrorCode::InvalidArgument, fmt::format("{} bins along a hemisphere's side, expected 2 .. 64", settings.side)};
    if (settings.samplesPerBin < 1 || settings.lightSamples < 1)
        return Error{ErrorCode::InvalidArgument, "no samples of a bin or of the lights, expected 1 or more"};
    if (settings.sampling == BinSampling::Centres && settings.sources == SourceSampling::Sought)
        return Error{ErrorCode::InvalidArgument, "sources can be sought only beside samples that are spread over their bins"};
    VertexSampler out(scene, estimator, settings, seed);
    if (!settings.ignored.empty()) out.ignored_.resize(scene.scene.objects.size());
    for (const auto& name : settings.ignored) {
        bool found = false;
        for (std::size_t i = 0; i < scene.scene.objects.size(); ++i)
            if (scene.scene.objects[i].name == name) out.ignored_[i] = 1, found = true;
        if (!found) return Error{ErrorCode::InvalidArgument, fmt::format("no object \"{}\" to be ignored", name)};
    }
    return out;
}

void VertexSampler::aim(const Vec3& position, std::uint64_t stream, std::uint32_t index, Round& round) const {
    const bool sought = settings_.sources == SourceSampling::Sought;
    round.queries.resize(centres_.size());
    round.samples.resize(centres_.size());
    for (std::size_t bin = 0; bin < centres_.size(); ++bin) {
        auto& query = round.queries[bin];
        query.numbers = SamplePath(streamSeed(stream, bin), index);
        const Vec2 within = query.numbers.next2D();
        query.ray.origin = position;
        query.ray.direction = settings_.sampling == BinSampling::Centres ? centres_[bin] : bins_.direction(static_cast<int>(bin), within);
        query.origin = Receiver{position};
        // Balance heuristic of #B directions against lightSamples lights: what counts is the ratio of their densities.
        query.pdfSolidAngle = sought ? static_cast<float>(static_cast<double>(centres_.size()) / (4 * kPiD * settings_.lightSamples)) : 0;
    }
}

void VertexSampler::seekSources(const Receiver& at, std::uint64_t stream, std::uint32_t index, Round& round, TransportCounters& counters) const {
    const auto weights = scene_.lights.weigh(at);
    const float pdfOfBins = round.queries.front().pdfSolidAngle;
    std::vector<Ray> rays;
    for (std::uint32_t i = 0; i < settings_.lightSamples; ++i) {
        SamplePath numbers(streamSeed(stream, 0, kLights), index * settings_.lightSamples + i);
        const float uSelect = numbers.next1D();
        const auto light = chooseLight(scene_, at, weights, uSelect, numbers.next2D());
        if (!light.lit()) continue;
        Rgb lux = light.weight * (1 / static_cast<float>(settings_.lightSamples));
        if (light.shared) lux *= light.pdfSolidAngle / (light.pdfSolidAngle + pdfOfBins);
        round.sources.push_back({light.direction, lux, true});
        rays.push_back({at.position, 0, light.direction, light.distance * (1 - kShadowShortening)});
    }
    std::vector<std::uint8_t> shadowed(rays.size());
    scene_.raycaster.occluded(rays, shadowed, Targets::Opaque);
    counters.rays += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        auto& source = round.sources[i];
        if (shadowed[i] != 0) source.lux = Rgb{};
        else if (scene_.needs.transmission) dim(source, paneTransmittance(scene_, rays[i], counters), round);
    }
}

void VertexSampler::seekByMirrors(const Receiver& at, std::uint64_t stream, std::uint32_t index, Round& round, TransportCounters& counters) const {
    const MirrorTable mirrors(scene_, at);
    const std::uint32_t count = std::max(1U, settings_.lightSamples / kRaysForEachMirrored);
    for (std::uint32_t i = 0; i < count; ++i) {
        SamplePath numbers(streamSeed(stream, 0, kMirrors), index * count + i);
        float u = numbers.next1D();
        const auto choice = mirrors.choose(u);
        const auto path = aimByMirror(scene_, at, choice.mirror, *choice.weights, u, numbers.next2D());
        if (!path) continue;
        round.sources.push_back({path->direction, path->light.weight * (1 / (choice.probability * static_cast<float>(count))), false});
        dim(round.sources.back(), throughputByMirror(scene_, at.position, *path, counters), round);
    }
}

/// What stands in the way has no value: between nothing and all of the light comes through.
void VertexSampler::dim(SourceRay& source, const Rgb& passed, Round& round) const {
    const Rgb lux = source.lux * passed;
    if (!isFinite(lux)) {
        auto& sample = round.samples[static_cast<std::size_t>(bins_.binOf(source.direction))];
        sample.failure = RayFailure::NotFinite;
        sample.lost += isFinite(source.lux) ? source.lux / static_cast<float>(bins_.solidAngleSr()) : Rgb(kInfinity);
    }
    source.lux = isFinite(lux) ? lux : Rgb{};
}

void VertexSampler::ignore(RadianceSample& sample) const {
    if (sample.object >= ignored_.size() || ignored_[sample.object] == 0) return;
    sample.emitted = sample.direct = sample.lost = Rgb{};
    sample.failure = RayFailure::None;
    sample.indirect = Rgb(settings_.ignoredCdM2);
}

std::array<float, 6> VertexSampler::axisLux(const Round& round) const {
    std::array<double, 6> sums{};
    for (std::size_t bin = 0; bin < centres_.size(); ++bin) addToAxes(sums, centres_[bin], luminance(round.samples[bin].total(), scene_.scene.weights) * bins_.solidAngleSr());
    for (const auto& source : round.sources) addToAxes(sums, source.direction, luminance(source.lux, scene_.scene.weights));
    std::array<float, 6> lux{};
    for (std::size_t i = 0; i < lux.size(); ++i) lux[i] = static_cast<float>(sums[i]);
    return lux;
}

/// What failed samples of a round may miss, as axisLux().
std::array<float, 6> VertexSampler::lostLux(const Round& round) const {
    std::array<double, 6> sums{};
    for (std::size_t bin = 0; bin < centres_.size(); ++bin) {
        const auto& lost = round.samples[bin].lost;
        if (!lost.isBlack()) addToAxes(sums, centres_[bin], luminance(lost, scene_.scene.weights) * bins_.solidAngleSr());
    }
    std::array<float, 6> lux{};
    for (std::size_t i = 0; i < lux.size(); ++i) lux[i] = std::isnan(sums[i]) ? kInfinity : static_cast<float>(sums[i]);
    return lux;
}

/// The round becomes a part of the means.
void VertexSampler::enter(const Round& round, VertexState& state) const {
    auto& q = state.quality;
    const float part = 1 / static_cast<float>(++q.samples);
    std::uint32_t backFaces = 0;
    for (std::size_t bin = 0; bin < centres_.size(); ++bin) {
        const auto& sample = round.samples[bin];
        q.rejected += sample.failure != RayFailure::None ? 1U : 0U;
        state.direct[bin] += (sample.emitted - state.direct[bin]) * part;
        state.indirect[bin] += (sample.direct + sample.indirect - state.indirect[bin]) * part;
        backFaces += sample.backFace ? 1U : 0U;
        q.nearestM = std::min(q.nearestM, sample.distance);
    }
    for (auto& source : state.sources) source.lux *= 1 - part;
    for (auto source : round.sources) source.lux *= part, state.sources.push_back(source);
    mergeByBin(state.sources, bins_, scene_.scene.weights);
    q.backFaces += (static_cast<float>(backFaces) / static_cast<float>(centres_.size()) - q.backFaces) * part;
    const auto lux = axisLux(round), lost = lostLux(round);
    for (std::size_t i = 0; i < lux.size(); ++i) {  // Welford 1962
        const float delta = lux[i] - q.lux[i];
        q.lux[i] += delta * part;
        q.spread[i] += delta * (lux[i] - q.lux[i]);
        // What failed samples miss is missing in all rounds alike: (2 n - 1) l^2, summed, is n^2 l^2, and the standard error
        // does not fall below what a round misses.
        q.spread[i] += lost[i] * lost[i] * static_cast<float>(2 * q.samples - 1);
    }
}

/// Whether a vertex' light is not that of the space around it.
bool VertexSampler::isInside(const Vec3& position, const VertexQuality& quality, TransportCounters& counters) const {
    // Seen from behind alone is no proof: walls without thickness have backs as well. Inside a closed solid it is dark, too.
    constexpr float kAlmostAll = 0.9F;
    if (quality.backFaces > kAlmostAll && quality.meanLux() == 0) return true;
    if (scene_.needs.dielectrics && !mediaAt(scene_, position, counters).inAir()) return true;
    // On a surface a vertex sees both of its sides, and would pass the light of one on to the other.
    const float reach = std::max(kOnSurfaceM, 64 * spacingAt(position));
    std::array<Ray, 3> rays;
    std::array<std::uint8_t, 3> met{};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 direction(0, 0, 0);
        direction[axis] = 1;
        rays[static_cast<std::size_t>(axis)] = {position - direction * reach, 0, direction, 2 * reach};
    }
    scene_.raycaster.occluded(rays, met, Targets::Surfaces);
    counters.rays += rays.size();
    return met[0] != 0 || met[1] != 0 || met[2] != 0;
}

void VertexSampler::sample(const Vec3& position, std::uint32_t samples, VertexState& state, TransportCounters& counters) const {
    const std::uint64_t stream = streamSeed(seed_, placeHash(position));
    if (state.quality.samples == 0) {
        state.direct.assign(centres_.size(), Rgb{});
        state.indirect.assign(centres_.size(), Rgb{});
        state.quality.nearestM = kInfinity;
    }
    Round round;
    while (state.quality.samples < samples) {
        const std::uint32_t index = state.quality.samples;
        aim(position, stream, index, round);
        counters += estimator_->radiance(round.queries, round.samples);
        if (!ignored_.empty())
            for (auto& sample : round.samples) ignore(sample);
        round.sources.clear();
        if (settings_.sources == SourceSampling::Sought) {
            seekSources(Receiver{position}, stream, index, round, counters);
            if (seeksByMirrors(scene_)) seekByMirrors(Receiver{position}, stream, index, round, counters);
        }
        enter(round, state);
    }
    state.quality.inside = isInside(position, state.quality, counters);
}

}  // namespace luxdeck
