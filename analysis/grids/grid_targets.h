#pragma once

#include "analysis/grids/grid_points.h"
#include "analysis/grids/measurement.h"

#include <vector>

namespace luxdeck {

/// The layouts of all grids of a project, in order.
///
/// errors  InvalidArgument: a grid that cannot be laid out
Result<std::vector<GridLayout>> layOutAll(const Project& project);

/// The sensors of all points, grid after grid, each with a random stream of its own.
///
/// layouts  #G, of project.grids
std::vector<Target> gridTargets(const Project& project, const std::vector<GridLayout>& layouts);

}  // namespace luxdeck
