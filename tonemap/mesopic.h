#pragma once

#include "engine/core/rgb.h"

namespace luxdeck::tonemap {

inline constexpr double kScotopicBelow = 5.6e-3;  ///< rods alone: no colour [cd/m^2]; Larson et al. 1997, section 5.3
inline constexpr double kPhotopicAbove = 5.6;  ///< cones alone: full colour [cd/m^2]

/// Luminance as rods see it, scaled so that a grey keeps its own. Blue gains, red loses (Purkinje's shift).
///
/// colour  linear Rec.709 [cd/m^2]
/// source  Larson et al. 1995, Ysc = Y (1.33 (1 + (Y + Z) / X) - 1.68)
double scotopicLuminance(const Rgb& colour);

/// The colour that is left at this luminance: a blend, linear in luminance, of the colour and scotopic grey.
Rgb withNightColours(const Rgb& colour);

}  // namespace luxdeck::tonemap
