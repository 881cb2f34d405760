#pragma once

#include "gui/session/camera_motion.h"

#include <optional>

namespace luxdeck::gui {

/// What a selected thing is held by.
enum class Handle {
    None,
    X, Y, Z,  ///< along an axis
    Plan,     ///< across the floor
    Turn      ///< about the vertical
};

/// Moves go in steps, so that things line up.
struct Snapping {
    double stepM = 0.1;
    double stepDeg = 15;

    static Snapping off() { return {0, 0}; }
    static Snapping fine() { return {0.01, 1}; }
};

struct GizmoMotion {
    Vec3d moveM{0, 0, 0};
    double turnDeg = 0;       ///< counter-clockwise as seen from above

    friend bool operator==(const GizmoMotion&, const GizmoMotion&) = default;
};

/// How far a thing goes whose handle was taken on one line of sight and is now on another.
///
/// centre   where the handles are, re-based [m]
/// returns  nothing when the lines do not tell (the plane or axis is seen from its edge)
std::optional<GizmoMotion> draggedBy(Handle handle, const Vec3d& centre, const SightLine& from, const SightLine& to, const Snapping& snapping);

}  // namespace luxdeck::gui
