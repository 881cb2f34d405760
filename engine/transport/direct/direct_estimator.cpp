#include "engine/transport/direct/direct_estimator.h"

#include "engine/transport/sensor/illuminance.h"

#include <memory>
#include <vector>

namespace luxdeck {

namespace {

class DirectEstimator final : public RadianceEstimator {
public:
    explicit DirectEstimator(const TransportScene& scene) : scene_(scene) {}

    TransportCounters radiance(std::span<const RadianceQuery> queries, std::span<RadianceSample> samples) const override {
        return tracePaths(scene_, {.maxReflections = 1}, queries, samples);
    }
    TransportCounters irradiance(std::span<const SensorQuery> queries, std::span<SensorSample> samples) const override {
        return gatherIlluminance(scene_, {.maxReflections = 0}, queries, samples);
    }
    [[nodiscard]] bool knowsSources() const override { return true; }
    TransportCounters irradianceBySource(std::span<const SensorQuery> queries, std::span<SensorSample> samples,
                                         std::vector<SourceShare>& shares) const override {
        shares.clear();
        return gatherIlluminance(scene_, {.maxReflections = 0, .shares = &shares}, queries, samples);
    }

private:
    TransportScene scene_;
};

}  // namespace

Result<std::unique_ptr<RadianceEstimator>> makeDirectEstimator(const TransportScene& scene, const AlgorithmSettings&) {
    return std::unique_ptr<RadianceEstimator>(std::make_unique<DirectEstimator>(scene));
}

}  // namespace luxdeck
