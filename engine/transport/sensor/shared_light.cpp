#include "engine/transport/sensor/shared_light.h"

#include "engine/transport/sensor/sensor_weight.h"

#include <cmath>
#include <vector>

namespace luxdeck {

namespace {

/// The group of sensors that starts at a query, and room for its rays.
class Group {
public:
    explicit Group(const TransportScene& scene) : scene_(scene) {}

    void share(std::span<const SensorQuery> queries, std::span<const MattePoint> points, std::span<const Rgb> reflected,
               std::span<SensorSample> samples, TransportCounters& counters) {
        sensors_ = queries;
        aimRays(points, reflected);
        shadowed_.resize(rays_.size());
        scene_.raycaster.occluded(rays_, shadowed_, Targets::Surfaces);
        counters.rays += rays_.size();
        distribute(points, reflected, samples);
    }

private:
    /// How much a sensor weighs a point by, visible or not; 0 from behind either.
    [[nodiscard]] float weight(const SensorQuery& sensor, const Vec3& from, const MattePoint& point) const {
        const Vec3 towards = point.position - from;
        const float d2 = towards.length2();
        if (!(d2 > 0)) return 0;
        const float d = std::sqrt(d2);
        if (dot(towards, point.geometricNormal) >= 0 || dot(towards, point.shadingNormal) >= 0) return 0;
        return sensorWeight(sensor.kind, dot(towards, sensor.normal) / d) / d2;
    }

    /// Row y, column i of the weights, and a ray for each pair that has one and is not a path's own.
    void aimRays(std::span<const MattePoint> points, std::span<const Rgb> reflected) {
        const std::size_t n = sensors_.size();
        weights_.assign(n * n, 0.0F);
        rays_.clear(), pairs_.clear(), origins_.clear();
        for (const auto& sensor : sensors_) origins_.push_back(receiverOf(sensor).position);
        for (std::size_t y = 0; y < n; ++y) {
            if (!points[y].met || reflected[y].isBlack()) continue;
            for (std::size_t i = 0; i < n; ++i) {
                const float w = weight(sensors_[i], origins_[i], points[y]);
                weights_[y * n + i] = w;
                if (i == y || !(w > 0)) continue;
                const Vec3 towards = points[y].position - origins_[i];
                const float d = towards.length();
                rays_.push_back({origins_[i], 0, towards / d, d * (1 - kShortening)});
                pairs_.push_back(y * n + i);
            }
        }
    }

    void distribute(std::span<const MattePoint> points, std::span<const Rgb> reflected, std::span<SensorSample> samples) {
        const std::size_t n = sensors_.size();
        for (std::size_t r = 0; r < rays_.size(); ++r)
            if (shadowed_[r] != 0) weights_[pairs_[r]] = 0;
        for (std::size_t y = 0; y < n; ++y) {
            if (!points[y].met) {
                samples[y].indirect += reflected[y] * kPi;
                continue;
            }
            float sum = 0;
            for (std::size_t i = 0; i < n; ++i) sum += weights_[y * n + i];
            if (!(sum > 0)) continue;
            for (std::size_t i = 0; i < n; ++i)
                if (weights_[y * n + i] > 0) samples[i].indirect += reflected[y] * (kPi * weights_[y * n + i] / sum);
        }
    }

    /// The point lies just off its surface; the ray stops short of it all the same, as shadow rays do.
    static constexpr float kShortening = 1e-5F;

    const TransportScene& scene_;
    std::span<const SensorQuery> sensors_;
    std::vector<Vec3> origins_;
    std::vector<float> weights_;  // #points x #sensors
    std::vector<Ray> rays_;
    std::vector<std::size_t> pairs_;
    std::vector<std::uint8_t> shadowed_;
};

}  // namespace

void shareReflectedLight(const TransportScene& scene, std::span<const SensorQuery> queries, std::span<const MattePoint> points,
                         std::span<const Rgb> reflected, std::span<SensorSample> samples, TransportCounters& counters) {
    Group group(scene);
    for (std::size_t first = 0; first < queries.size();) {
        std::size_t end = first + 1;
        while (end < queries.size() && queries[first].group != kNothing && queries[end].group == queries[first].group) ++end;
        const std::size_t count = end - first;
        group.share(queries.subspan(first, count), points.subspan(first, count), reflected.subspan(first, count),
                    samples.subspan(first, count), counters);
        first = end;
    }
}

}  // namespace luxdeck
