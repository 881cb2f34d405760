#include "engine/transport/shared_path/shared_path_estimator.h"

#include "engine/transport/sensor/illuminance.h"

#include <fmt/format.h>

#include <cstdlib>
#include <memory>

namespace luxdeck {

namespace {

class SharedPathEstimator final : public RadianceEstimator {
public:
    SharedPathEstimator(const TransportScene& scene, int maxVertices) : scene_(scene) { settings_.maxVertices = maxVertices; if (getenv("LS")) sensors_.lightSamples = atoi(getenv("LS")); if (getenv("GO")) sensors_.goesOn = atof(getenv("GO")); }

    TransportCounters radiance(std::span<const RadianceQuery> queries, std::span<RadianceSample> samples) const override {
        return tracePaths(scene_, settings_, queries, samples);
    }
    TransportCounters irradiance(std::span<const SensorQuery> queries, std::span<SensorSample> samples) const override {
        return gatherIlluminance(scene_, settings_, queries, samples, sensors_);
    }
    [[nodiscard]] std::size_t groupSize() const override { return 16; }

private:
    TransportScene scene_;
    TracerSettings settings_;
    SensorSettings sensors_{.lightSamples = 4, .goesOn = 0.25F, .share = true};
};

}  // namespace

Result<std::unique_ptr<RadianceEstimator>> makeSharedPathEstimator(const TransportScene& scene, const AlgorithmSettings& settings) {
    if (settings.maxVertices < 2 || settings.maxVertices > 1'000'000)
        return Error{ErrorCode::InvalidArgument, fmt::format("maxVertices is {}, expected 2 .. 1000000", settings.maxVertices)};
    return std::unique_ptr<RadianceEstimator>(std::make_unique<SharedPathEstimator>(scene, settings.maxVertices));
}

}  // namespace luxdeck
