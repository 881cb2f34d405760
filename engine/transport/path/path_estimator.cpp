#include "engine/transport/path/path_estimator.h"

#include <fmt/format.h>

#include <memory>
#include <vector>

namespace luxdeck {

namespace {

class PathEstimator final : public RadianceEstimator {
public:
    PathEstimator(const TransportScene& scene, int maxVertices, const SensorSettings& sensors, std::size_t groupSize)
        : scene_(scene), sensors_(sensors), groupSize_(groupSize) {
        settings_.maxVertices = maxVertices;
    }

    TransportCounters radiance(std::span<const RadianceQuery> queries, std::span<RadianceSample> samples) const override {
        return tracePaths(scene_, settings_, queries, samples);
    }
    TransportCounters irradiance(std::span<const SensorQuery> queries, std::span<SensorSample> samples) const override {
        return gatherIlluminance(scene_, settings_, queries, samples, sensors_);
    }
    [[nodiscard]] std::size_t groupSize() const override { return groupSize_; }
    /// What a sensor took from its neighbours' paths carries no mark of its light.
    [[nodiscard]] bool knowsSources() const override { return !sensors_.share; }
    TransportCounters irradianceBySource(std::span<const SensorQuery> queries, std::span<SensorSample> samples,
                                         std::vector<SourceShare>& shares) const override {
        auto settings = settings_;
        shares.clear();
        if (knowsSources()) settings.shares = &shares;
        return gatherIlluminance(scene_, settings, queries, samples, sensors_);
    }

private:
    TransportScene scene_;
    TracerSettings settings_;
    SensorSettings sensors_;
    std::size_t groupSize_;
};

}  // namespace

Result<std::unique_ptr<RadianceEstimator>> makePathEstimator(const TransportScene& scene, const AlgorithmSettings& settings) {
    return makePathEstimator(scene, settings, SensorSettings{}, 1);
}

Result<std::unique_ptr<RadianceEstimator>> makePathEstimator(const TransportScene& scene, const AlgorithmSettings& settings,
                                                             const SensorSettings& sensors, std::size_t groupSize) {
    if (settings.maxVertices < 2 || settings.maxVertices > 1'000'000)
        return Error{ErrorCode::InvalidArgument, fmt::format("maxVertices is {}, expected 2 .. 1000000", settings.maxVertices)};
    return std::unique_ptr<RadianceEstimator>(std::make_unique<PathEstimator>(scene, settings.maxVertices, sensors, groupSize));
}

}  // namespace luxdeck
