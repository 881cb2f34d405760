#pragma once

#include "analysis/grids/sampling_run.h"
#include "tests/support/scenes.h"

namespace luxdeck::test {

/// A value and its standard error.
struct Estimate {
    double value = 0;
    double standardError = 0;
};

/// Illuminance at a sensor, sampled until the 95 % interval is at most `relative` of the value (or 2^22 paths).
struct SensorEstimate {
    Estimate direct, indirect, total;
};
SensorEstimate illuminance(const Lit& lit, const RadianceEstimator& estimator, const SensorQuery& sensor, double relative,
                           std::uint64_t seed = 1);

/// Mean of the same over many sensors, with the error of the mean.
SensorEstimate meanIlluminance(const Lit& lit, const RadianceEstimator& estimator, const std::vector<SensorQuery>& sensors,
                               double relative, std::uint64_t seed = 1);

inline SensorQuery facing(Vec3 position, Vec3 normal) { return {position, normal.normalized(), SensorKind::Planar, {}}; }

}  // namespace luxdeck::test
