#pragma once

#include "analysis/grids/solve_result.h"
#include "engine/volume/volume.h"

#include <optional>
#include <vector>

namespace luxdeck::gui {

/// One part of the light at a point of a calculation surface [lx].
Interval lightOf(const PointResult& point, LightPart part);

/// The values of a surface, rows from v = 0 [lx].
std::vector<double> valuesOf(const GridResult& grid, LightPart part);

/// The illuminance at a place of a surface, between its points [lx].
///
/// user     on the surface, in user coordinates [m]
/// returns  nothing for free points and beside the surface; the interval is that of the nearest point
std::optional<Interval> lightAt(const GridResult& grid, LightPart part, const Vec3d& user);

}  // namespace luxdeck::gui
