#pragma once

#include "engine/transport/radiance_estimator.h"

#include <cstddef>

namespace luxdeck {

/// Next-event estimation's choice between the sky and all other lights; both are asked through here, so that the
/// densities of one know the chance of the other.
LightSample chooseLight(const TransportScene& scene, const Receiver& at, float uSelect, Vec2 u);
/// The same for a receiver whose lamps were weighed before.
LightSample chooseLight(const TransportScene& scene, const Receiver& at, const LightSampler::Weights& weights,
                        float uSelect, Vec2 u);

/// The chance that another light than the sky is chosen: a factor of every density of LightSampler.
float lampChance(const TransportScene& scene, const Receiver& at);

enum class Suns { With, Without };

/// Radiance of the sky and its suns along a direction that was sampled at `at` with a density (0: no other strategy
/// looks for light there), weighed against next-event estimation.
Rgb skyRadiance(const TransportScene& scene, const Receiver& at, const Vec3& direction, float pdfSolidAngle, Suns suns = Suns::With);

}  // namespace luxdeck
