#pragma once

#include "engine/transport/radiance_estimator.h"

#include <memory>

namespace luxdeck {

/// Unbiased path tracing; see the card beside this file.
Result<std::unique_ptr<RadianceEstimator>> makePathEstimator(const TransportScene& scene,
                                                             const AlgorithmSettings& settings);

}  // namespace luxdeck
