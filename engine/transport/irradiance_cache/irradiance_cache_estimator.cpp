#include "engine/transport/irradiance_cache/irradiance_cache_estimator.h"

#include "engine/transport/irradiance_cache/irradiance_cache.h"
#include "engine/transport/sensor/illuminance.h"
#include "engine/transport/tracer/path_batch.h"

#include <memory>
#include <utility>

namespace luxdeck {

namespace {

class IrradianceCacheEstimator final : public RadianceEstimator {
public:
    IrradianceCacheEstimator(const TransportScene& scene, int maxVertices, std::unique_ptr<IrradianceCache> cache)
        : scene_(scene), cache_(std::move(cache)) {
        settings_.maxVertices = maxVertices;
        settings_.field = cache_.get();
    }

    TransportCounters radiance(std::span<const RadianceQuery> queries, std::span<RadianceSample> samples) const override {
        return tracePaths(scene_, settings_, queries, samples);
    }
    /// A final gather: the cache answers where the sensor's own ray ends.
    TransportCounters irradiance(std::span<const SensorQuery> queries, std::span<SensorSample> samples) const override {
        return gatherIlluminance(scene_, settings_, queries, samples);
    }
    [[nodiscard]] std::size_t bytes() const override { return cache_->bytes(); }

private:
    TransportScene scene_;
    std::unique_ptr<IrradianceCache> cache_;
    TracerSettings settings_;
};

}  // namespace

Result<std::unique_ptr<RadianceEstimator>> makeIrradianceCacheEstimator(const TransportScene& scene, const AlgorithmSettings& settings) {
    auto cache = makeIrradianceCache(scene, settings);
    if (!cache) return cache.error();
    return std::unique_ptr<RadianceEstimator>(std::make_unique<IrradianceCacheEstimator>(scene, settings.maxVertices, *std::move(cache)));
}

}  // namespace luxdeck
