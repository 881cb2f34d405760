#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/transport/tracer/path_batch.h"

#include <span>

namespace luxdeck {

/// What a group of sensors makes of each other's paths. A path from sensor j was first scattered at y, which sends
/// the radiance B to sensor j, of which the diffuse part differs to other sensors by a known factor of the angle
/// alone: every sensor of the group that sees y straight receives it too. Sensor i weighs it by the balance
/// heuristic over the group (Veach & Guibas 1995), with one path for each sensor k that sees y:
///
///     pi B (g_i / g_j) w_i c_i / d_i^2  /  sum_k (w_k c_k / d_k^2)
///
/// w: sensor's weight of the direction, c: cosine at y, d: distance between them, g: factor of the angle.
/// The term is at most what sensor i's own path would count there.
///
/// queries    #Q, groups consecutive
/// bounces    #Q; what was not met straight, and what is not diffuse, is left to the path's own sensor
/// reflected  #Q, all reflected radiance of each path
/// samples    #Q, to whose indirect is added
void shareReflectedLight(const TransportScene& scene, std::span<const SensorQuery> queries, std::span<const FirstBounce> bounces,
                         std::span<const Rgb> reflected, std::span<SensorSample> samples, TransportCounters& counters);

}  // namespace luxdeck
