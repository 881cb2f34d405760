#pragma once

#include "engine/transport/radiance_estimator.h"

#include <memory>

namespace luxdeck {

/// See README.md in this folder.
///
/// settings  effort, seed, progress, maxVertices
/// errors    InvalidArgument: a setting out of range; Cancelled
Result<std::unique_ptr<RadianceEstimator>> makeIrradianceCacheEstimator(const TransportScene& scene, const AlgorithmSettings& settings);

}  // namespace luxdeck
