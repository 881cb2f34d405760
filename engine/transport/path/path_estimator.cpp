#include "engine/transport/path/path_estimator.h"

#include "engine/transport/sensor/illuminance.h"

#include <fmt/format.h>

#include <memory>
#include <vector>

namespace luxdeck {

namespace {

class PathEstimator final : public RadianceEstimator {
public:
    PathEstimator(const TransportScene& scene, int maxVertices) : scene_(scene) { settings_.maxVertices = maxVertices; }

    TransportCounters radiance(std::span<const RadianceQuery> queries, std::span<RadianceSample> samples) const override {
        return tracePaths(scene_, settings_, queries, samples);
    }
    TransportCounters irradiance(std::span<const SensorQuery> queries, std::span<SensorSample> samples) const override {
        return gatherIlluminance(scene_, settings_, queries, samples);
    }
    [[nodiscard]] bool knowsSources() const override { return true; }
    TransportCounters irradianceBySource(std::span<const SensorQuery> queries, std::span<SensorSample> samples,
                                         std::vector<SourceShare>& shares) const override {
        auto settings = settings_;
        shares.clear();
        settings.shares = &shares;
        return gatherIlluminance(scene_, settings, queries, samples);
    }

private:
    TransportScene scene_;
    TracerSettings settings_;
};

}  // namespace

Result<std::unique_ptr<RadianceEstimator>> makePathEstimator(const TransportScene& scene, const AlgorithmSettings& settings) {
    if (settings.maxVertices < 2 || settings.maxVertices > 1'000'000)
        return Error{ErrorCode::InvalidArgument, fmt::format("maxVertices is {}, expected 2 .. 1000000", settings.maxVertices)};
    return std::unique_ptr<RadianceEstimator>(std::make_unique<PathEstimator>(scene, settings.maxVertices));
}

}  // namespace luxdeck
