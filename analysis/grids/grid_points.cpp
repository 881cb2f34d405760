#include "analysis/grids/grid_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

constexpr double kMostPoints = 1e6;

GridLayout freePoints(const CalculationGrid& grid) {
    GridLayout layout;
    for (const auto& [position, normal] : grid.points) {
        layout.points.push_back(position);
        layout.normals.push_back(grid.kind == GridKind::Cylindrical ? Vec3d(0, 0, 1) : normal.normalized());
    }
    return layout;
}

/// Cells along a side; the small slack keeps a side that is a multiple of the spacing from gaining one.
double cellsAlong(double length, double spacing) { return std::max(1.0, std::ceil(length / spacing - 1e-9)); }

}  // namespace

double gridSpacingM(double d) { return std::min(10.0, 0.2 * std::pow(5.0, std::log10(d))); }

Result<GridLayout> layOut(const CalculationGrid& grid) {
    if (!grid.points.empty()) return freePoints(grid);
    const double fullU = grid.u.length(), fullV = grid.v.length();
    const double lengthU = fullU - 2 * grid.borderM, lengthV = fullV - 2 * grid.borderM;
    if (!(lengthU > 0 && lengthV > 0))
        return Error{ErrorCode::InvalidArgument,
                     fmt::format("grid \"{}\": a border of {} m leaves nothing of {} x {} m", grid.name, grid.borderM,
                                 fullU, fullV), grid.where};
    const double longer = std::max(lengthU, lengthV), shorter = std::min(lengthU, lengthV);
    const double spacing = grid.spacingM.value_or(gridSpacingM(longer >= 2 * shorter ? shorter : longer));
    const double cellsU = grid.counts ? (*grid.counts)[0] : cellsAlong(lengthU, spacing);
    const double cellsV = grid.counts ? (*grid.counts)[1] : cellsAlong(lengthV, spacing);
    if (cellsU * cellsV > kMostPoints)
        return Error{ErrorCode::InvalidArgument,
                     fmt::format("grid \"{}\" would have {} x {} points, expected at most a million", grid.name, cellsU,
                                 cellsV), grid.where};
    const Vec3d alongU = grid.u / fullU, alongV = grid.v / fullV;
    const Vec3d normal = grid.kind == GridKind::Cylindrical ? Vec3d(0, 0, 1) : grid.u.cross(grid.v).normalized();
    GridLayout layout;
    layout.columns = static_cast<int>(cellsU), layout.rows = static_cast<int>(cellsV);
    layout.origin = grid.origin + (alongU + alongV) * grid.borderM;
    layout.u = alongU * lengthU, layout.v = alongV * lengthV;
    for (int row = 0; row < layout.rows; ++row)
        for (int column = 0; column < layout.columns; ++column) {
            layout.points.push_back(layout.origin + layout.u * ((column + 0.5) / cellsU) + layout.v * ((row + 0.5) / cellsV));
            layout.normals.push_back(normal);
        }
    return layout;
}

}  // namespace luxdeck
