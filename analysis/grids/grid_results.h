#pragma once

#include "analysis/grids/grid_points.h"
#include "analysis/grids/measurement.h"
#include "analysis/grids/solve_result.h"

#include <vector>

namespace luxdeck {

/// Whether the noise of a grid's points is independent, or common to neighbours that shared light.
enum class PointErrors { Independent, GoTogether };

/// Points, statistics and verdicts of every grid from the samples so far.
///
/// layouts  #G, of project.grids
/// sums     of all points, grid after grid
std::vector<GridResult> gridResults(const Project& project, const std::vector<GridLayout>& layouts,
                                    const std::vector<PointSums>& sums, PointErrors errors = PointErrors::Independent);

/// Half-width over value; 0 where light is certainly nil.
double relativeError(const Interval& interval);
/// The same of a point, a dark one relative to kDarkPoint of its grid's mean.
double pointError(const GridResult& grid, const PointResult& point);
/// Over Ēm, Emin and Uo of all grids; of free points, over the points.
double largestStatisticError(const std::vector<GridResult>& grids);
double rmsPointError(const std::vector<GridResult>& grids);

}  // namespace luxdeck
