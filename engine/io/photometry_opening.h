#pragma once

#include "engine/scene/candela_table.h"

namespace luxdeck::photometry {

/// No side of an opening is thinner: a line or an edge-on plane has no area for its luminance.
/// source  Radiance's ies2rad takes 1 mm for the same purpose
inline constexpr double kThinnestM = 1e-3;

LuminousOpening disc(double diameterM);
LuminousOpening sphere(double diameterM);
LuminousOpening uprightCylinder(double diameterM, double heightM);
/// A rectangle, or a box if heightM > 0; sides of 0 become kThinnestM.
LuminousOpening boxOrRectangle(double lengthM, double widthM, double heightM);

/// A warning if an opening is too large to be true, the usual sign of a wrong unit.
void warnIfHuge(Photometry& photometry);

}  // namespace luxdeck::photometry
