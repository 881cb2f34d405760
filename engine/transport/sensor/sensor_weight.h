#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/transport/surface/surface_point.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

/// The weight of light from a direction at cosine c to the sensor's normal or axis, and pi times the density by
/// which the sensor chooses directions, whichever the kind.
inline float sensorWeight(SensorKind kind, float c) {
    return kind == SensorKind::Planar ? std::max(c, 0.0F) : std::sqrt(std::max(0.0F, 1 - c * c)) / kPi;
}

/// A planar sensor sits just off the surface that it may lie on; a cylinder where it is.
inline Receiver receiverOf(const SensorQuery& query) {
    if (query.kind == SensorKind::Cylindrical) return {query.position};
    return {query.position + query.normal * (16 * spacingAt(query.position)), query.normal};
}

}  // namespace luxdeck
