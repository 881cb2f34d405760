#pragma once

#include "engine/scene/object_pose.h"

#include <cmath>

namespace luxdeck::gui {

/// What hands on a handle are rounded to.
struct SnapSteps {
    double metres = 0.1;
    double degrees = 15;
};

/// Puts an object's pivot on the grid of the user's coordinates, along the axes on which it was moved alone, and its turn on
/// a step.
///
/// pivotUser  where the pivot was before the move [m]
inline Pose snapped(const Pose& pose, const Vec3d& pivotUser, const SnapSteps& steps = {}) {
    Pose out = pose;
    for (int axis = 0; axis < 3; ++axis)
        if (pose.moveM[axis] != 0) out.moveM[axis] = std::round((pivotUser[axis] + pose.moveM[axis]) / steps.metres) * steps.metres - pivotUser[axis];
    out.turnDeg = std::round(pose.turnDeg / steps.degrees) * steps.degrees;
    return out;
}

}  // namespace luxdeck::gui
