#pragma once

#include "engine/transport/radiance_estimator.h"

#include <memory>

namespace luxdeck {

/// Light without interreflection; see the card beside this file.
Result<std::unique_ptr<RadianceEstimator>> makeDirectEstimator(const TransportScene& scene,
                                                               const AlgorithmSettings& settings);

}  // namespace luxdeck
