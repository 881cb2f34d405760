#include "engine/transport/photon_map/photon_map_estimator.h"

#include "engine/transport/photon_map/photon_field.h"
#include "engine/transport/sensor/field_gather.h"

#include <utility>

namespace luxdeck {

Result<std::unique_ptr<RadianceEstimator>> makePhotonMapEstimator(const TransportScene& scene, const AlgorithmSettings& settings) {
    auto field = PhotonField::create(scene, settings);
    if (!field) return field.error();
    const std::size_t bytes = (*field)->bytes();
    return makeFieldGather(scene, settings, *std::move(field), bytes);
}

}  // namespace luxdeck
