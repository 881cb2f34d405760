#include "engine/transport/sensor/illuminance.h"

#include "engine/sampling/warp.h"
#include "engine/transport/sensor/sensor_weight.h"
#include "engine/transport/sensor/shared_light.h"
#include "engine/transport/tracer/mirrored_light.h"
#include "engine/transport/tracer/light_choice.h"
#include "engine/transport/tracer/media.h"
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
    LightRound(const TransportScene& scene, std::size_t count, int perPath) : scene_(scene), perPath_(perPath), media_(scene) {
        rays_.reserve(count), contributions_.reserve(count);
    }

    /// Lights for a sensor, each counting for its part, and one by way of a mirror or pane.
    void look(std::uint32_t index, const SensorQuery& query, const Receiver& at, bool byMirrors, SamplePath& numbers) {
        const auto& place = placeOf(at, byMirrors);
        if (perPath_ == 1) {
            choose(index, query, place, numbers);
        } else {
            for (int i = 0; i < perPath_; ++i) {
                auto finer = numbers.finer(static_cast<std::uint32_t>(perPath_), static_cast<std::uint32_t>(i));
                choose(index, query, place, finer);
            }
        }
        if (byMirrors) chooseByMirror(index, query, place, numbers);
    }

    void trace(std::span<SensorSample> samples, std::vector<SourceShare>* shares, TransportCounters& counters) {
        traceLights(samples, shares, counters);
        traceMirrored(samples, shares, counters);
    }

private:
    /// A place where lights were weighed. A batch asks thousands of times at one, or at the few of a group in turn.
    struct Place {
        Receiver at;
        LightSampler::Weights weights;
        std::optional<MirrorTable> mirrors;
    };

    static constexpr std::size_t kMostPlaces = 64;  // more are not a group asked in turn: remembering is in vain

    const Place& placeOf(const Receiver& at, bool byMirrors) {
        for (std::size_t tried = 0; tried < places_.size(); ++tried, last_ = (last_ + 1) % places_.size())
            if (places_[last_].at.position == at.position && places_[last_].at.normal == at.normal) {
                const auto& place = places_[last_];
                last_ = (last_ + 1) % places_.size();  // the next of the group comes next
                return place;
            }
        Place place{at, scene_.lights.weigh(at), std::nullopt};
        if (byMirrors) place.mirrors.emplace(scene_, at);
        last_ = 0;
        if (places_.size() >= kMostPlaces) places_.clear();
        return places_.emplace_back(std::move(place));
    }

    void choose(std::uint32_t index, const SensorQuery& query, const Place& place, SamplePath& numbers) {
        const float uSelect = numbers.next1D();
        const auto light = chooseLight(scene_, place.at, place.weights, uSelect, numbers.next2D());
        if (!light.lit()) return;
        const float weight = sensorWeight(query.kind, dot(light.direction, query.normal));
        if (!(weight > 0)) return;
        Rgb contribution = light.weight * (weight / static_cast<float>(perPath_));
        if (light.shared) contribution *= light.pdfSolidAngle / (light.pdfSolidAngle + weight / kPi);
        contributions_.push_back({contribution, index, light.source});
        rays_.push_back({place.at.position, 0, light.direction, light.distance * (1 - kShadowShortening)});
    }

    void chooseByMirror(std::uint32_t index, const SensorQuery& query, const Place& place, SamplePath& numbers) {
        float u = numbers.next1D();
        const auto choice = place.mirrors->choose(u);
        const auto path = aimByMirror(scene_, place.at, choice.mirror, *choice.weights, u, numbers.next2D());
        if (!path) return;
        const float weight = sensorWeight(query.kind, dot(path->direction, query.normal));
        if (weight > 0) mirrored_.push_back({*path, path->light.weight * (weight / choice.probability), place.at.position, index});
    }

    void traceMirrored(std::span<SensorSample> samples, std::vector<SourceShare>* shares, TransportCounters& counters) {
        for (const auto& m : mirrored_) {
            const Rgb contribution = m.light * throughputByMirror(scene_, m.origin, m.path, counters);
            if (!isFinite(contribution)) {
                lose(samples[m.index], m.light);
                continue;
            }
            samples[m.index].indirect += contribution;
            if (shares != nullptr && !contribution.isBlack()) shares->push_back({contribution, m.index, m.path.light.source, false});
        }
    }

    void traceLights(std::span<SensorSample> samples, std::vector<SourceShare>* shares, TransportCounters& counters) {
        shadowed_.resize(rays_.size());
        scene_.raycaster.occluded(rays_, shadowed_, Targets::Opaque);
        counters.rays += rays_.size();
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            if (shadowed_[i] != 0) continue;
            Rgb contribution = contributions_[i].light;
            if (scene_.needs.transmission) contribution *= paneTransmittance(scene_, rays_[i], counters);
            if (scene_.needs.dielectrics)  // a sensor inside a solid, and a light in the same
                contribution *= media_.at(rays_[i].origin, counters).transmittance(rays_[i].tMax / (1 - kShadowShortening));
            if (!isFinite(contribution)) {
                lose(samples[contributions_[i].index], contributions_[i].light);
                continue;
            }
            samples[contributions_[i].index].direct += contribution;
            if (shares != nullptr) shares->push_back({contribution, contributions_[i].index, contributions_[i].source, true});
        }
    }

    /// What stands in the way, or the light itself, has no value: at most all of the light is missing.
    static void lose(SensorSample& sample, const Rgb& most) {
        sample.failure = RayFailure::NotFinite;
        sample.lost += isFinite(most) ? most : Rgb(kInfinity);
    }

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
    std::vector<Place> places_;
    std::size_t last_ = 0;  // where in places_ the next query probably is
    MediaFinder media_;
    std::vector<Ray> rays_;
    std::vector<Contribution> contributions_;
    std::vector<std::uint8_t> shadowed_;
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

/// Nothing is known of what is missing.
const Rgb kUnbounded(std::numeric_limits<float>::infinity());

bool isGood(const SensorQuery& query) { return isFinite(query.position) && isFinite(query.normal); }

}  // namespace

TransportCounters gatherIlluminance(const TransportScene& scene, const TracerSettings& settings,
                                    std::span<const SensorQuery> queries, std::span<SensorSample> samples,
                                    const SensorSettings& sensors) {
    std::vector<RadianceQuery> directions(queries.size());
    std::vector<RadianceSample> radiances(queries.size());
    TransportCounters counters;
    const bool byMirrors = seeksByMirrors(scene) && settings.maxReflections > 0;
    LightRound lights(scene, queries.size(), sensors.lightSamples);
    for (std::uint32_t i = 0; i < queries.size(); ++i) {
        samples[i] = SensorSample{};
        if (!isGood(queries[i])) {
            directions[i].ray.origin.x = std::numeric_limits<float>::quiet_NaN();  // comes back as a bad ray
            continue;
        }
        const auto at = receiverOf(queries[i]);
        auto numbers = queries[i].numbers;
        lights.look(i, queries[i], at, byMirrors, numbers);
        const Vec2 u = numbers.next2D();
        directions[i] = directionQuery(queries[i], at, numbers, u);
    }
    auto* shares = settings.shares;
    lights.trace(samples, shares, counters);
    const std::size_t firstOfPaths = shares != nullptr ? shares->size() : 0;
    auto tracer = settings;
    std::vector<FirstBounce> bounces(sensors.share ? queries.size() : 0);
    tracer.bounces = bounces;
    tracer.goesOn = sensors.share ? sensors.goesOn : 1;
    if (sensors.share) tracer.control = sensors.control, tracer.controlWeight = sensors.controlWeight;
    counters += tracePaths(scene, tracer, directions, radiances);
    if (sensors.share) {
        std::vector<Rgb> reflected(queries.size());
        for (std::size_t i = 0; i < queries.size(); ++i) reflected[i] = radiances[i].direct + radiances[i].indirect;
        shareReflectedLight(scene, queries, bounces, reflected, samples, counters);
    }
    for (std::size_t i = firstOfPaths; shares != nullptr && i < shares->size(); ++i) (*shares)[i].light *= kPi;
    counters.rejected = 0;  // of sensors: what failed on the way to a light counts as well
    for (std::size_t i = 0; i < queries.size(); ++i) {
        auto& sample = samples[i];
        sample.direct += radiances[i].emitted * kPi;  // weight over density is pi for both kinds
        if (!sensors.share) sample.indirect += (radiances[i].direct + radiances[i].indirect) * kPi;
        sample.sawBackFace = radiances[i].backFace;
        sample.lost += radiances[i].lost * kPi;
        sample.lostAt = radiances[i].lostAt;
        sample.chance.add(radiances[i].chance, kPi);
        if (radiances[i].failure != RayFailure::None) sample.failure = radiances[i].failure;
        for (auto* part : {&sample.direct, &sample.indirect})
            if (!isFinite(*part)) sample.failure = RayFailure::NotFinite, sample.lost = kUnbounded, *part = Rgb{};
        if (sample.failure != RayFailure::None) ++counters.rejected;
    }
    return counters;
}

}  // namespace luxdeck
