#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/transport/tracer/irradiance_field.h"

#include <cstddef>
#include <memory>

namespace luxdeck {

/// An estimator that sees the light of a field: final gather, as all algorithms with a field do it.
///
/// A sensor's path ends at the first matte surface that it meets, whose indirect light the field tells; direct light
/// there is sampled, and what is not matte is followed. A ray of a picture asks the field one reflection later: what
/// is seen straight is gathered too, and the field's own roughness shows in mirrors alone.
///
/// fieldBytes  of the field [bytes]
std::unique_ptr<RadianceEstimator> makeFieldGather(const TransportScene& scene, const AlgorithmSettings& settings,
                                                   std::unique_ptr<const IrradianceField> field, std::size_t fieldBytes);

}  // namespace luxdeck
