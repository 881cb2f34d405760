#include "engine/transport/sensor/shared_light.h"

#include "engine/transport/sensor/sensor_weight.h"
#include "engine/transport/surface/bsdf.h"
#include "engine/transport/tracer/shadow.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace luxdeck {

namespace {

/// A bounce lies just off its surface; rays stop short of it all the same.
constexpr float kShortening = 1e-5F;

/// One group after the other, in the same memory.
class Group {
public:
    explicit Group(const TransportScene& scene) : scene_(scene) {}

    void share(std::span<const SensorQuery> sensors, std::span<const FirstBounce> bounces, std::span<const Rgb> reflected,
               std::span<SensorSample> samples, TransportCounters& counters) {
        sensors_ = sensors, bounces_ = bounces;
        aimRays();
        shadowed_.resize(rays_.size());
        scene_.raycaster.occluded(rays_, shadowed_, Targets::Surfaces);
        counters.rays += rays_.size();
        for (std::size_t r = 0; r < rays_.size(); ++r)
            if (shadowed_[r] != 0) lookThroughPanes(r, counters);
        for (std::size_t y = 0; y < sensors.size(); ++y) {
            const Rgb own = reflected[y] - (shared(y) ? bounces[y].diffuse : Rgb{});
            samples[y].indirect += Rgb(std::max(own.r, 0.0F), std::max(own.g, 0.0F), std::max(own.b, 0.0F)) * kPi;
            if (shared(y)) distribute(y, samples);
        }
    }

private:
    [[nodiscard]] bool shared(std::size_t y) const { return bounces_[y].met && !bounces_[y].diffuse.isBlack(); }

    /// How densely a sensor's directions fall on the surface at the bounce, times pi [1/m^2]; 0 from behind.
    [[nodiscard]] static float density(const SensorQuery& sensor, const Vec3& towards, const FirstBounce& bounce) {
        const float d2 = towards.length2();
        if (!(d2 > 0) || dot(towards, bounce.shadingNormal) >= 0) return 0;
        const float d = std::sqrt(d2), cosineThere = -dot(towards, bounce.geometricNormal) / d;
        return cosineThere > 0 ? sensorWeight(sensor.kind, dot(towards, sensor.normal) / d) * cosineThere / d2 : 0.0F;
    }

    /// Something is in the way of a ray: panes dim it, all else ends it.
    void lookThroughPanes(std::size_t r, TransportCounters& counters) {
        std::uint8_t blocked = 1;
        if (scene_.needs.transmission) {
            scene_.raycaster.occluded({&rays_[r], 1}, {&blocked, 1}, Targets::Opaque);
            ++counters.rays;
        }
        const auto passage = blocked != 0 ? Passage{Rgb{}, 0} : passageThroughPanes(scene_, rays_[r], counters);
        // Where a pane has no value the sensor's own paths are lost, and it takes no part in sharing.
        weights_[pairs_[r]] *= passage.chance > 0 ? passage.chance : 0.0F;
        if (passage.chance > 0) passed_[pairs_[r]] = passage.transmittance * (1 / passage.chance);
    }

    /// Row y, column i of the weights, and a ray for each pair that has one and is not a path's own.
    void aimRays() {
        const std::size_t n = sensors_.size();
        weights_.assign(n * n, 0.0F);
        if (scene_.needs.transmission) passed_.assign(n * n, Rgb(1.0F));
        rays_.clear(), pairs_.clear(), origins_.clear();
        for (const auto& sensor : sensors_) origins_.push_back(receiverOf(sensor).position);
        for (std::size_t y = 0; y < n; ++y) {
            if (!shared(y)) continue;
            for (std::size_t i = 0; i < n; ++i) {
                const Vec3 towards = bounces_[y].position - origins_[i];
                const float w = density(sensors_[i], towards, bounces_[y]);
                weights_[y * n + i] = w;
                if (!(w > 0) || (i == y && !bounces_[y].behindPanes)) continue;
                const float d = towards.length();
                rays_.push_back({origins_[i], 0, towards / d, d * (1 - kShortening)});
                pairs_.push_back(y * n + i);
            }
        }
    }

    void distribute(std::size_t y, std::span<SensorSample> samples) const {
        const std::size_t n = sensors_.size();
        float sum = 0;
        for (std::size_t i = 0; i < n; ++i) sum += weights_[y * n + i];
        if (!(sum > 0)) {  // the path's own direction grazes: rounding
            samples[y].indirect += bounces_[y].diffuse * kPi;
            return;
        }
        const auto& bounce = bounces_[y];
        const auto coat = coatOf(y);
        const Rgb left = partOf(bounce.diffuse, bounce.passed);  // what left the surface, panes apart
        const Rgb light = coat ? quotient(left, coat->diffuseFactor(cosineTo(y, bounce))) : left;
        for (std::size_t i = 0; i < n; ++i) {
            const float weight = weights_[y * n + i];
            if (!(weight > 0)) continue;
            Rgb received = light * (kPi * weight / sum);
            if (scene_.needs.transmission) received *= passed_[y * n + i];
            samples[i].indirect += coat ? received * coat->diffuseFactor(cosineTo(i, bounce)) : received;
        }
    }

    /// The surface of a bounce whose light depends on the angle it is seen at; none where it does not.
    [[nodiscard]] std::optional<Bsdf<Rgb>> coatOf(std::size_t y) const {
        const auto& bounce = bounces_[y];
        if (!bounce.coated) return std::nullopt;
        const Ray ray{origins_[y], 0, (bounce.position - origins_[y]).normalized(), kInfinity};
        return Bsdf<Rgb>(scene_.scene, scene_.needs, surfacePoint(scene_.scene, scene_.needs, ray, bounce.hit));
    }

    [[nodiscard]] float cosineTo(std::size_t sensor, const FirstBounce& bounce) const {
        return std::max(dot((origins_[sensor] - bounce.position).normalized(), bounce.shadingNormal), 0.0F);
    }

    const TransportScene& scene_;
    std::span<const SensorQuery> sensors_;
    std::span<const FirstBounce> bounces_;
    std::vector<Vec3> origins_;
    std::vector<float> weights_;  // #bounces x #sensors
    std::vector<Rgb> passed_;     // #bounces x #sensors: transmittance of panes over the chance of passing; where there are any
    std::vector<Ray> rays_;
    std::vector<std::size_t> pairs_;  // index into weights_
    std::vector<std::uint8_t> shadowed_;
};

}  // namespace

void shareReflectedLight(const TransportScene& scene, std::span<const SensorQuery> queries, std::span<const FirstBounce> bounces,
                         std::span<const Rgb> reflected, std::span<SensorSample> samples, TransportCounters& counters) {
    Group group(scene);
    for (std::size_t first = 0; first < queries.size();) {
        std::size_t end = first + 1;
        while (end < queries.size() && queries[first].group != kNothing && queries[end].group == queries[first].group) ++end;
        const std::size_t count = end - first;
        group.share(queries.subspan(first, count), bounces.subspan(first, count), reflected.subspan(first, count),
                    samples.subspan(first, count), counters);
        first = end;
    }
}

}  // namespace luxdeck
