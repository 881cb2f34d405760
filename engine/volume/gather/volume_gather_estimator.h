#pragma once

#include "engine/transport/radiance_estimator.h"

#include <memory>

namespace luxdeck {

/// Final gather from surfaces that an irradiance volume lights; see the card beside this file. The volume is built first,
/// by path tracing.
///
/// errors  Cancelled, OutOfResources
Result<std::unique_ptr<RadianceEstimator>> makeVolumeGatherEstimator(const TransportScene& scene, const AlgorithmSettings& settings);

}  // namespace luxdeck
