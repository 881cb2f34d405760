#include "engine/transport/shared/shared_estimator.h"

#include "engine/transport/path/path_estimator.h"

namespace luxdeck {

namespace {

// Measured on projects/office: variance times time is flat about these.
constexpr SensorSettings kSharing{.lightSamples = 4, .goesOn = 0.5F, .share = true};
constexpr std::size_t kGroup = 32;

}  // namespace

Result<std::unique_ptr<RadianceEstimator>> makeSharedEstimator(const TransportScene& scene, const AlgorithmSettings& settings) {
    return makePathEstimator(scene, settings, kSharing, kGroup);
}

}  // namespace luxdeck
