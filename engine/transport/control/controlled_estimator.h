#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/transport/tracer/irradiance_field.h"

#include <memory>

namespace luxdeck {

/// Unbiased illuminance with light that was found before as the control variate; see the card beside this file.
///
/// field   any, however wrong: where its value is not finite it says nothing. A null field is refused
/// errors  InvalidArgument: maxVertices out of range, no field
Result<std::unique_ptr<RadianceEstimator>> makeControlledEstimator(const TransportScene& scene, const AlgorithmSettings& settings,
                                                                   std::shared_ptr<const IrradianceField> field);
/// The same with a coarse radiosity solution, as registered.
Result<std::unique_ptr<RadianceEstimator>> makeControlledEstimator(const TransportScene& scene, const AlgorithmSettings& settings);

/// The part of the field's word that leaves least to chance: sum D F / sum F^2 over surfaces, D being one path's
/// indirect light. 0 for a field that knows nothing, 1 for one that is right.
float controlWeight(const TransportScene& scene, const AlgorithmSettings& settings, const IrradianceField& field);

}  // namespace luxdeck
