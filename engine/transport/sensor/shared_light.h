#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/transport/tracer/path_batch.h"

#include <span>

namespace luxdeck {

/// What a group of sensors makes of each other's paths. A path from sensor j met the matte surface at y and found
/// the radiance B that leaves y: every sensor of the group that sees y receives it too. Sensor i weighs it by
/// the balance heuristic over the group (Veach & Guibas 1995), one path for each sensor k that sees y:
///
///     pi B w_i / d_i^2  /  sum_k (w_k / d_k^2)          w: sensor's weight of the direction, d: distance to y
///
/// (the cosine at y cancels). The term is at most pi B, what sensor i's own path would count: variance only falls.
///
/// queries    #Q, groups consecutive
/// points     #Q, what each path met; those not met are left to their own sensor
/// reflected  #Q, radiance B of each path
/// samples    #Q, whose indirect is set
void shareReflectedLight(const TransportScene& scene, std::span<const SensorQuery> queries, std::span<const MattePoint> points,
                         std::span<const Rgb> reflected, std::span<SensorSample> samples, TransportCounters& counters);

}  // namespace luxdeck
