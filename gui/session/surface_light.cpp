#include "gui/session/surface_light.h"

#include "analysis/grids/grid_field.h"

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

Interval lightOf(const PointResult& point, LightPart part) {
    switch (part) {
        case LightPart::Direct: return point.direct;
        case LightPart::Indirect: return point.indirect;
        case LightPart::Total: break;
    }
    return point.total;
}

std::vector<double> valuesOf(const GridResult& grid, LightPart part) {
    std::vector<double> values;
    values.reserve(grid.points.size());
    for (const auto& point : grid.points) values.push_back(lightOf(point, part).value);
    return values;
}

std::optional<Interval> lightAt(const GridResult& grid, LightPart part, const Vec3d& user) {
    if (grid.columns < 1 || grid.rows < 1 || grid.points.empty()) return {};
    const Vec3d d = user - grid.origin;
    const double a = d.dot(grid.u) / grid.u.dot(grid.u), b = d.dot(grid.v) / grid.v.dot(grid.v);
    if (!(a >= 0 && a <= 1 && b >= 0 && b <= 1)) return {};
    const double x = a * grid.columns - 0.5, y = b * grid.rows - 0.5;
    const auto column = std::clamp(static_cast<int>(std::lround(x)), 0, grid.columns - 1);
    const auto row = std::clamp(static_cast<int>(std::lround(y)), 0, grid.rows - 1);
    auto light = lightOf(grid.points[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(column)], part);
    light.value = sampleField(valuesOf(grid, part), grid.columns, grid.rows, x, y);
    return light;
}

}  // namespace luxdeck::gui
