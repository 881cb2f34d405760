#pragma once

#include "engine/core/rgb.h"
#include "engine/scene/scene.h"
#include "engine/transport/surface/surface_point.h"

namespace luxdeck {

/// Which of a mixture's parts a path meets, chosen by a number in [0, 1); any other material is itself.
/// Null where the pattern has no value.
const Material* meetMaterial(const Scene& scene, const SurfacePoint& point, float u);

/// The part of light that goes on in its direction, on average over holes and mixtures: what a shadow ray
/// keeps, and a path meets by chance [-]. NaN where a pattern has no value.
Rgb straightTransmittance(const Scene& scene, const SurfacePoint& point);

}  // namespace luxdeck
