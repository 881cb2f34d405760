#include "engine/transport/ambient/ambient_estimator.h"

#include "engine/transport/sensor/illuminance.h"

#include <fmt/format.h>

#include <memory>

namespace luxdeck {

namespace {

class AmbientEstimator final : public RadianceEstimator {
public:
    AmbientEstimator(const TransportScene& scene, double ambientLux)
        : scene_(scene), ambient_(static_cast<float>(ambientLux)) {}

    TransportCounters radiance(std::span<const RadianceQuery> queries, std::span<RadianceSample> samples) const override {
        return tracePaths(scene_, {.maxReflections = 1, .ambientRadiance = ambient_ * (1 / kPi)}, queries, samples);
    }
    TransportCounters irradiance(std::span<const SensorQuery> queries, std::span<SensorSample> samples) const override {
        const auto counters = gatherIlluminance(scene_, {.maxReflections = 0}, queries, samples);
        for (auto& sample : samples) sample.indirect += ambient_;
        return counters;
    }

private:
    TransportScene scene_;
    Rgb ambient_;
};

}  // namespace

Result<std::unique_ptr<RadianceEstimator>> makeAmbientEstimator(const TransportScene& scene, const AlgorithmSettings& settings) {
    if (!(settings.ambientLux >= 0 && settings.ambientLux <= 1e6))
        return Error{ErrorCode::InvalidArgument, fmt::format("ambient is {} lx, expected 0 .. 1e6", settings.ambientLux)};
    return std::unique_ptr<RadianceEstimator>(std::make_unique<AmbientEstimator>(scene, settings.ambientLux));
}

}  // namespace luxdeck
