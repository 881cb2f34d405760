#pragma once

#include "engine/transport/radiance_estimator.h"

#include <memory>

namespace luxdeck {

/// Path tracing whose neighbouring sensors share what their paths found; see the card beside this file.
Result<std::unique_ptr<RadianceEstimator>> makeSharedEstimator(const TransportScene& scene,
                                                             const AlgorithmSettings& settings);

}  // namespace luxdeck
