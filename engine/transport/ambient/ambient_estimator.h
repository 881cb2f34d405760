#pragma once

#include "engine/transport/radiance_estimator.h"

#include <memory>

namespace luxdeck {

/// Direct light and a constant ambient term; see the card beside this file.
Result<std::unique_ptr<RadianceEstimator>> makeAmbientEstimator(const TransportScene& scene,
                                                                const AlgorithmSettings& settings);

}  // namespace luxdeck
