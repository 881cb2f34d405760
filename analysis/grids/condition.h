#pragma once

#include "analysis/grids/measurement.h"
#include "analysis/grids/solve_result.h"
#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace luxdeck {

/// From this amplification on (mean reflectance 0.95) an error of 0.01 in the reflectances, which is as well as they are
/// mostly known, shifts every value by a fifth.
inline constexpr double kBadAmplification = 20;
/// More lost energy than this is no longer small against the 2 % that solves aim at by default.
inline constexpr double kBadTruncation = 1e-3;
/// Fewer effective replicates than half: their means scatter by more than themselves, a few bright paths carry the value,
/// and Student's t, which assumes them nearly normal, understates the interval.
inline constexpr double kBadReplicates = kReplicates / 2.0;

/// How well posed a solve was.
///
/// sums     of every point; those much darker than the mean (kDarkPoint) and those without samples are passed over
Condition conditionOf(const Scene& scene, const std::vector<PointSums>& sums);

/// A sentence for each figure that is bad: what it means for the result.
std::vector<std::string> conditionWarnings(const Condition& condition, double truncatedFraction);

}  // namespace luxdeck
