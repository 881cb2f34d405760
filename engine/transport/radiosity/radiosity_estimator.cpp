#include "engine/transport/radiosity/radiosity_estimator.h"

#include "engine/transport/radiosity/radiosity_field.h"
#include "engine/transport/sensor/field_gather.h"

#include <utility>

namespace luxdeck {

Result<std::unique_ptr<RadianceEstimator>> makeRadiosityEstimator(const TransportScene& scene, const AlgorithmSettings& settings) {
    auto field = RadiosityField::create(scene, settings);
    if (!field) return field.error();
    const std::size_t bytes = (*field)->bytes();
    return makeFieldGather(scene, settings, *std::move(field), bytes);
}

}  // namespace luxdeck
