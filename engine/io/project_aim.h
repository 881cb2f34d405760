#pragma once

#include "engine/core/vec.h"

namespace luxdeck {

/// The frame of a luminaire whose nadir (local -z) points along `aim`.
///
/// Straight down, C0 is +x and C90 is +y. For any other aim both are carried along by the smallest turn that takes
/// straight down to `aim`: about the horizontal axis at right angles to both. That is continuous everywhere but at
/// straight up, where every axis would do and +y is taken: C0 is -x, C90 is +y. Afterwards `rotationDeg` turns C0
/// towards C90 about the aim (counter-clockwise in plan for a luminaire that points down).
///
/// aim        any length but zero
Frame luminaireFrame(const Vec3d& aim, double rotationDeg);

}  // namespace luxdeck
