#pragma once

#include "engine/core/vec.h"
#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace luxdeck {

enum class PlanLine {
    Solid,     ///< what the cut meets: walls, columns
    Glass,     ///< a pane in the cut: an opening
    Furniture  ///< the outline of a movable object that may lie below the cut
};

struct PlanSegment {
    PlanLine line = PlanLine::Solid;
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // [m], user coordinates
};

struct PlanLuminaire {
    std::string id;             // of its type
    Vec3d position{0, 0, 0};    // [m], user coordinates
    double lengthM = 0;         // of the luminous opening along its C0 plane; 0: a point
    double widthM = 0;
    double angle = 0;           // of the C0 plane in the plan, from x towards y [rad]
    bool round = false;
};

/// The room from above, in the user's coordinates.
struct RoomPlan {
    double cutHeightM = 0;      // z of the cut
    std::vector<PlanSegment> segments;
    std::vector<PlanLuminaire> luminaires;
};

/// Cuts the scene's geometry with the plane z = heightM. Movable objects that end below the cut are drawn
/// by the outline of their top. Pieces that lie on one line are joined.
///
/// heightM  1  of the cut, user coordinates [m]
/// returns  segments in a fixed order (by line, kind and position)
/// cost     O(#T log #T)
std::vector<PlanSegment> planSection(const Scene& scene, double heightM);

/// The section together with the luminaires as they hang.
RoomPlan roomPlan(const Scene& scene, double heightM);

}  // namespace luxdeck
