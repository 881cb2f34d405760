#pragma once

#include "engine/transport/radiance_estimator.h"

#include <memory>

namespace luxdeck {

/// A photon map seen by final gather; see the card beside this file.
Result<std::unique_ptr<RadianceEstimator>> makePhotonMapEstimator(const TransportScene& scene, const AlgorithmSettings& settings);

}  // namespace luxdeck
