#pragma once

#include "analysis/grids/solve_result.h"
#include "engine/algorithms/lit_project.h"
#include "gui/session/display.h"
#include "gui/session/scene_parts.h"
#include "gui/session/selection.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace luxdeck::gui {

/// What of a project a view shows, as far as it matters for what is under the cursor.
struct Visible {
    const LitProject* project = nullptr;
    const SceneParts* parts = nullptr;
    const SolveResult* result = nullptr;   ///< its surfaces can be picked; null: those of the project
    std::uint32_t hiddenSides = 0;         ///< as SceneParts::sidesInTheWay()
    bool surfaces = true, luminaires = true, grids = true;
    std::optional<std::size_t> onlyGrid;   ///< the calculation surface that is not see-through; none: all are solid
    CutPlane section;
};

struct Picked {
    Selection what;
    double distanceM = std::numeric_limits<double>::infinity();
    Vec3d point{0, 0, 0};    ///< re-based [m]
    Vec3d normal{0, 0, 1};   ///< unit, towards the eye

    [[nodiscard]] bool any() const { return distanceM < std::numeric_limits<double>::infinity(); }
};

/// A point of the section plane: what lies beyond it along its normal is cut away.
Vec3d sectionPoint(const CutPlane& section, const Box3& bounds);
/// How far a plane may move along its normal from the middle of the bounds and still cut them [m]; 1 for empty bounds.
double sectionReachM(const Box3& bounds, const Vec3d& normal);

/// The first surface, luminaire or calculation surface on a line of sight that is not hidden or cut away.
Picked pick(const Visible& visible, const SightLine& line);
/// All things on it, nearest first, each once: for clicks that ask for what lies behind.
std::vector<Picked> pickAll(const Visible& visible, const SightLine& line);
/// Whether points can be seen from the camera: nothing that is shown hides them. Points themselves may lie on surfaces.
///
/// seen  #points
void seePoints(const Visible& visible, const CameraPose& pose, const std::vector<Vec3d>& points, std::vector<std::uint8_t>& seen);

}  // namespace luxdeck::gui
