#include "engine/transport/sensor/illuminance.h"

#include "engine/sampling/warp.h"
#include "engine/transport/sensor/sensor_weight.h"
#include "engine/transport/sensor/shared_light.h"
#include "engine/transport/tracer/mirrored_light.h"
#include "engine/transport/tracer/shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace luxdeck {

namespace {

/// Chooses a light for every sensor; contributions that are not shadowed go to `samples`.
class LightRound {
public:
    LightRound(const TransportScene& scene, std::size_t count, int perPath) : scene_(scene), perPath_(perPath) {
        rays_.reserve(count), contributions_.reserve(count);
    }

    /// perPath lights for a sensor, each counting for its part.
    void chooseAll(std::uint32_t index, const SensorQuery& query, const Receiver& at, SamplePath& numbers) {
        if (perPath_ == 1) return choose(index, query, at, numbers);
        for (int i = 0; i < perPath_; ++i) {
            auto finer = numbers.finer(static_cast<std::uint32_t>(perPath_), static_cast<std::uint32_t>(i));
            choose(index, query, at, finer);
        }
    }

private:

    void choose(std::uint32_t index, const SensorQuery& query, const Receiver& at, SamplePath& numbers) {
        if (!weighed_ || at.position != weighedAt_.position || at.normal != weighedAt_.normal) {
            weights_ = scene_.lights.weigh(at);
            weighedAt_ = at, weighed_ = true;
        }
        const float uSelect = numbers.next1D();
        const auto light = scene_.lights.sample(at, weights_, uSelect, numbers.next2D());
        if (!light.lit()) return;
        const float weight = sensorWeight(query.kind, dot(light.direction, query.normal));
        if (!(weight > 0)) return;
        Rgb contribution = light.weight * (weight / static_cast<float>(perPath_));
        if (light.shared) contribution *= light.pdfSolidAngle / (light.pdfSolidAngle + weight / kPi);
        contributions_.push_back({contribution, index, light.source});
        rays_.push_back({at.position, 0, light.direction, light.distance * (1 - kShadowShortening)});
    }

public:
    /// One light by way of a mirror or pane.
    void chooseByMirror(std::uint32_t index, const SensorQuery& query, const Receiver& at, SamplePath& numbers) {
        if (!table_ || at.position != tableAt_.position || at.normal != tableAt_.normal) table_.emplace(scene_, at), tableAt_ = at;
        float u = numbers.next1D();
        const auto choice = table_->choose(u);
        const auto path = aimByMirror(scene_, at, choice.mirror, *choice.weights, u, numbers.next2D());
        if (!path) return;
        const float weight = sensorWeight(query.kind, dot(path->direction, query.normal));
        if (weight > 0) mirrored_.push_back({*path, path->light.weight * (weight / choice.probability), at.position, index});
    }

    void traceMirrored(std::span<SensorSample> samples, std::vector<SourceShare>* shares, TransportCounters& counters) {
        for (const auto& m : mirrored_) {
            const Rgb contribution = m.light * throughputByMirror(scene_, m.origin, m.path, counters);
            samples[m.index].indirect += contribution;
            if (shares != nullptr && !contribution.isBlack()) shares->push_back({contribution, m.index, m.path.light.source, false});
        }
    }

    void trace(std::span<SensorSample> samples, std::vector<SourceShare>* shares, TransportCounters& counters) {
        shadowed_.resize(rays_.size());
        scene_.raycaster.occluded(rays_, shadowed_, Targets::Opaque);
        counters.rays += rays_.size();
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            if (shadowed_[i] != 0) continue;
            Rgb contribution = contributions_[i].light;
            if (scene_.needs.transmission) contribution *= paneTransmittance(scene_, rays_[i], counters);
            samples[contributions_[i].index].direct += contribution;
            if (shares != nullptr) shares->push_back({contribution, contributions_[i].index, contributions_[i].source, true});
        }
    }

private:
    struct Contribution {
        Rgb light;
        std::uint32_t index;
        LightSource source;
    };
    struct Mirrored {
        MirrorPath path;
        Rgb light;
        Vec3 origin;
        std::uint32_t index;
    };
    const TransportScene& scene_;
    int perPath_;
    std::vector<Mirrored> mirrored_;
    std::optional<MirrorTable> table_;  // of tableAt_
    Receiver tableAt_;
    std::vector<Ray> rays_;
    std::vector<Contribution> contributions_;
    std::vector<std::uint8_t> shadowed_;
    LightSampler::Weights weights_;  // of the lights at weighedAt_: a batch asks mostly at one place
    Receiver weighedAt_;
    bool weighed_ = false;
};

RadianceQuery directionQuery(const SensorQuery& query, const Receiver& at, const SamplePath& numbers, Vec2 u) {
    const auto frame = Frame::about(query.normal);
    const Vec3 local = query.kind == SensorKind::Planar ? cosineHemisphere(u) : sineSphere(u);
    RadianceQuery out;
    out.ray = {at.position, 0, frame.toWorld(local), kInfinity};
    out.numbers = numbers;
    out.pdfSolidAngle = std::max(sensorWeight(query.kind, local.z) / kPi, 1e-12F);
    out.origin = at;
    return out;
}

bool isGood(const SensorQuery& query) { return isFinite(query.position) && isFinite(query.normal); }

}  // namespace

TransportCounters gatherIlluminance(const TransportScene& scene, const TracerSettings& settings,
                                    std::span<const SensorQuery> queries, std::span<SensorSample> samples,
                                    const SensorSettings& sensors) {
    std::vector<RadianceQuery> directions(queries.size());
    std::vector<RadianceSample> radiances(queries.size());
    TransportCounters counters;
    const bool byMirrors = !scene.mirrors.empty() && !scene.lights.empty() && settings.maxReflections > 0;
    LightRound lights(scene, queries.size(), sensors.lightSamples);
    for (std::uint32_t i = 0; i < queries.size(); ++i) {
        samples[i] = SensorSample{};
        if (!isGood(queries[i])) {
            directions[i].ray.origin.x = std::numeric_limits<float>::quiet_NaN();  // comes back as a bad ray
            continue;
        }
        const auto at = receiverOf(queries[i]);
        auto numbers = queries[i].numbers;
        lights.chooseAll(i, queries[i], at, numbers);
        if (byMirrors) lights.chooseByMirror(i, queries[i], at, numbers);
        const Vec2 u = numbers.next2D();
        directions[i] = directionQuery(queries[i], at, numbers, u);
    }
    auto* shares = settings.shares;
    lights.trace(samples, shares, counters);
    if (byMirrors) lights.traceMirrored(samples, shares, counters);
    const std::size_t firstOfPaths = shares != nullptr ? shares->size() : 0;
    auto tracer = settings;
    std::vector<MattePoint> points(sensors.share ? queries.size() : 0);
    tracer.mattePoints = points;
    counters += tracePaths(scene, tracer, directions, radiances);
    if (sensors.share) {
        std::vector<Rgb> reflected(queries.size());
        for (std::size_t i = 0; i < queries.size(); ++i) reflected[i] = radiances[i].direct + radiances[i].indirect;
        shareReflectedLight(scene, queries, points, reflected, samples, counters);
    }
    for (std::size_t i = firstOfPaths; shares != nullptr && i < shares->size(); ++i) (*shares)[i].light *= kPi;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        auto& sample = samples[i];
        sample.direct += radiances[i].emitted * kPi;  // weight over density is pi for both kinds
        if (!sensors.share) sample.indirect += (radiances[i].direct + radiances[i].indirect) * kPi;
        sample.sawBackFace = radiances[i].backFace;
        sample.failure = radiances[i].failure;
        if (sample.failure == RayFailure::None && !isFinite(sample.total())) sample.failure = RayFailure::NotFinite;
        if (sample.failure != RayFailure::None) sample.direct = sample.indirect = Rgb{};
    }
    if (shares != nullptr)
        std::erase_if(*shares, [&](const SourceShare& s) { return samples[s.query].failure != RayFailure::None; });
    return counters;
}

}  // namespace luxdeck
