#include "analysis/grids/grid_targets.h"

namespace luxdeck {

Result<std::vector<GridLayout>> layOutAll(const Project& project) {
    std::vector<GridLayout> layouts;
    for (const auto& grid : project.grids) {
        auto layout = layOut(grid);
        if (!layout) return layout.error();
        layouts.push_back(*std::move(layout));
    }
    return layouts;
}

std::vector<Target> gridTargets(const Project& project, const std::vector<GridLayout>& layouts) {
    std::vector<Target> targets;
    for (std::size_t g = 0; g < layouts.size(); ++g)
        for (std::size_t i = 0; i < layouts[g].points.size(); ++i) {
            Target target;
            target.sensor.position = project.scene.toRebased(layouts[g].points[i]);
            target.sensor.normal = Vec3(layouts[g].normals[i]);
            target.sensor.kind = project.grids[g].kind == GridKind::Cylindrical ? SensorKind::Cylindrical : SensorKind::Planar;
            target.grid = static_cast<std::uint32_t>(g);
            target.stream = targets.size();
            targets.push_back(target);
        }
    return targets;
}

}  // namespace luxdeck
