#include "engine/transport/shared/shared_estimator.h"

#include "engine/transport/sensor/illuminance.h"

#include <fmt/format.h>

#include <memory>

namespace luxdeck {

namespace {

class SharedEstimator final : public RadianceEstimator {
public:
    SharedEstimator(const TransportScene& scene, int maxVertices) : scene_(scene) { settings_.maxVertices = maxVertices; }

    TransportCounters radiance(std::span<const RadianceQuery> queries, std::span<RadianceSample> samples) const override {
        return tracePaths(scene_, settings_, queries, samples);
    }
    TransportCounters irradiance(std::span<const SensorQuery> queries, std::span<SensorSample> samples) const override {
        return gatherIlluminance(scene_, settings_, queries, samples, sensors_);
    }
    [[nodiscard]] std::size_t groupSize() const override { return 32; }

private:
    TransportScene scene_;
    TracerSettings settings_;
    // Measured on projects/office: error times time is flat about these.
    SensorSettings sensors_{.lightSamples = 4, .goesOn = 0.5F, .share = true};
};

}  // namespace

Result<std::unique_ptr<RadianceEstimator>> makeSharedEstimator(const TransportScene& scene, const AlgorithmSettings& settings) {
    if (settings.maxVertices < 2 || settings.maxVertices > 1'000'000)
        return Error{ErrorCode::InvalidArgument, fmt::format("maxVertices is {}, expected 2 .. 1000000", settings.maxVertices)};
    return std::unique_ptr<RadianceEstimator>(std::make_unique<SharedEstimator>(scene, settings.maxVertices));
}

}  // namespace luxdeck
