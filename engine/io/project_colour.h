#pragma once

#include "engine/core/rgb.h"

namespace luxdeck {

/// The colour temperatures for which daylightColour() is known [K].
inline constexpr double kLowestColourTemperatureK = 1667;
inline constexpr double kHighestColourTemperatureK = 25000;

/// Linear Rec.709 of a source of this correlated colour temperature, of luminance 1.
///
/// Planck's locus up to 4000 K, CIE daylight from 5000 K, between them a linear mix of the two chromaticities (as
/// in TM-30). White is that of 6500 K: it comes out as exactly (1, 1, 1). Negative primaries (blue below 1900 K,
/// outside Rec.709) become zero, and luminance is 1 again.
///
/// kelvin     1667 .. 25000
/// source     Kim et al., US patent 7024034 (cubic fits of Planck's locus); CIE 15 (daylight)
Rgb daylightColour(double kelvin);

}  // namespace luxdeck
