#include "engine/transport/sensor/illuminance.h"

#include "engine/sampling/warp.h"
#include "engine/transport/surface/surface_point.h"
#include "engine/transport/tracer/light_choice.h"
#include "engine/transport/tracer/media.h"
#include "engine/transport/tracer/shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace luxdeck {

namespace {

/// The weight of light from a direction at cosine c to the sensor's normal or axis, and the density by
/// which the sensor chooses directions: its weight over pi, whichever the kind.
float sensorWeight(SensorKind kind, float c) {
    return kind == SensorKind::Planar ? std::max(c, 0.0F) : std::sqrt(std::max(0.0F, 1 - c * c)) / kPi;
}

/// A planar sensor sits just off the surface that it may lie on; a cylinder where it is.
Receiver receiverOf(const SensorQuery& query) {
    if (query.kind == SensorKind::Cylindrical) return {query.position};
    return {query.position + query.normal * (16 * spacingAt(query.position)), query.normal};
}

/// Chooses a light for every sensor; contributions that are not shadowed go to `samples`.
class LightRound {
public:
    LightRound(const TransportScene& scene, std::size_t count) : scene_(scene), media_(scene) {
        rays_.reserve(count), contributions_.reserve(count);
    }

    void choose(std::uint32_t index, const SensorQuery& query, const Receiver& at, SamplePath& numbers) {
        if (!weighed_ || at.position != weighedAt_.position || at.normal != weighedAt_.normal) {
            weights_ = scene_.lights.weigh(at);
            weighedAt_ = at, weighed_ = true;
        }
        const float uSelect = numbers.next1D();
        const auto light = chooseLight(scene_, at, weights_, uSelect, numbers.next2D());
        if (!light.lit()) return;
        const float weight = sensorWeight(query.kind, dot(light.direction, query.normal));
        if (!(weight > 0)) return;
        Rgb contribution = light.weight * weight;
        if (light.shared) contribution *= light.pdfSolidAngle / (light.pdfSolidAngle + weight / kPi);
        contributions_.push_back({contribution, index, light.source});
        rays_.push_back({at.position, 0, light.direction, light.distance * (1 - kShadowShortening)});
    }

    void trace(std::span<SensorSample> samples, std::vector<SourceShare>* shares, TransportCounters& counters) {
        shadowed_.resize(rays_.size());
        scene_.raycaster.occluded(rays_, shadowed_, Targets::Opaque);
        counters.rays += rays_.size();
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            if (shadowed_[i] != 0) continue;
            Rgb contribution = contributions_[i].light;
            if (scene_.needs.transmission) contribution *= paneTransmittance(scene_, rays_[i], counters);
            if (scene_.needs.dielectrics)  // a sensor inside a solid, and a light in the same
                contribution *= media_.at(rays_[i].origin, counters).transmittance(rays_[i].tMax / (1 - kShadowShortening));
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
    const TransportScene& scene_;
    MediaFinder media_;
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
                                    std::span<const SensorQuery> queries, std::span<SensorSample> samples) {
    std::vector<RadianceQuery> directions(queries.size());
    std::vector<RadianceSample> radiances(queries.size());
    TransportCounters counters;
    LightRound lights(scene, queries.size());
    for (std::uint32_t i = 0; i < queries.size(); ++i) {
        samples[i] = SensorSample{};
        if (!isGood(queries[i])) {
            directions[i].ray.origin.x = std::numeric_limits<float>::quiet_NaN();  // comes back as a bad ray
            continue;
        }
        const auto at = receiverOf(queries[i]);
        auto numbers = queries[i].numbers;
        lights.choose(i, queries[i], at, numbers);
        const Vec2 u = numbers.next2D();
        directions[i] = directionQuery(queries[i], at, numbers, u);
    }
    auto* shares = settings.shares;
    lights.trace(samples, shares, counters);
    const std::size_t firstOfPaths = shares != nullptr ? shares->size() : 0;
    counters += tracePaths(scene, settings, directions, radiances);
    for (std::size_t i = firstOfPaths; shares != nullptr && i < shares->size(); ++i) (*shares)[i].light *= kPi;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        auto& sample = samples[i];
        sample.direct += radiances[i].emitted * kPi;  // weight over density is pi for both kinds
        sample.indirect = (radiances[i].direct + radiances[i].indirect) * kPi;
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
