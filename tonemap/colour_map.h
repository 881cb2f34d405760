#pragma once

#include "engine/core/result.h"
#include "tonemap/canvas.h"

#include <string_view>

namespace luxdeck::tonemap {

enum class ColourMap {
    Dusk,  ///< dark blue, teal, green, yellow: lightness rises evenly, safe for all kinds of colour blindness
    Heat,  ///< black, red, orange, yellow, white
    Balance  ///< of signed values: blue below, near white in the middle, red above; ends of equal lightness
};

/// "dusk", "heat", "balance".
std::string_view name(ColourMap map);
/// errors  InvalidArgument: not one of these
Result<ColourMap> colourMapNamed(std::string_view name);

/// The colour at t, 0..1 (clamped). Its points are ours, in Oklab (Ottosson 2020), with lightness proportional to t.
Colour8 colourAt(ColourMap map, double t);

/// What stands for values that are not numbers: in neither map.
inline constexpr Colour8 kNotANumber{255, 0, 200};

}  // namespace luxdeck::tonemap
