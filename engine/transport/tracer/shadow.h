#pragma once

#include "engine/transport/radiance_estimator.h"

namespace luxdeck {

/// A shadow ray stops this fraction short of the light, so that a light that lies on a surface is not
/// hidden by it.
inline constexpr float kShadowShortening = 1e-4F;

/// What the panes, holes and mixtures between the ends of a ray let through [-]; NaN where a pattern has no value.
/// A pane's two triangles meet on its diagonal, where the kernel reports both: one pane counts once.
Rgb paneTransmittance(const TransportScene& scene, Ray ray, TransportCounters& counters);

/// What glass panes between the ends of a ray let through, and the chance that a path goes straight through all of
/// them; both 0 where what lets light through is not plain glass.
struct Passage {
    Rgb transmittance{1.0F};
    float chance = 1;
};
Passage passageThroughPanes(const TransportScene& scene, const Ray& ray, TransportCounters& counters);

}  // namespace luxdeck
