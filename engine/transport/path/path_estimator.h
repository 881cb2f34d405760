#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/transport/sensor/illuminance.h"

#include <cstddef>
#include <memory>

namespace luxdeck {

/// Unbiased path tracing; see the card beside this file.
Result<std::unique_ptr<RadianceEstimator>> makePathEstimator(const TransportScene& scene,
                                                             const AlgorithmSettings& settings);
/// The same with sensors that look for light in another way, best asked in groups of this size.
Result<std::unique_ptr<RadianceEstimator>> makePathEstimator(const TransportScene& scene, const AlgorithmSettings& settings,
                                                             const SensorSettings& sensors, std::size_t groupSize);

}  // namespace luxdeck
