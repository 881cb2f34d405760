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

/// The angles by which IES LM-72 places a luminaire (its system "counter-clockwise from east"), each turn about the
/// axes as the turns before it have left them.
struct AimAngles {
    double orientDeg = 0;  ///< about up: C0 from east (+x) to north (+y)
    double tiltDeg = 0;    ///< about C90: the nadir rises towards where C0 points
    double rollDeg = 0;    ///< about C0: the nadir rises towards where C90 points
    double spinDeg = 0;    ///< about the photometric axis: C0 towards C90
};
Frame luminaireFrame(const AimAngles& angles);

/// The orientation and tilt that aim a luminaire so: C0, and with it the "up" of types A and B, stays in the vertical
/// plane of the aim. Straight up or down: orientation 0.
///
/// aim        any length but zero
AimAngles uprightAim(const Vec3d& aim);

}  // namespace luxdeck
