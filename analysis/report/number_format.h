#pragma once

#include "engine/core/statistics.h"

#include <string>

namespace luxdeck {

/// "512 ± 8": the half-width is rounded up to one digit (two when it starts with 1), the value to the same
/// place, so that no digit is printed that is not known. "not known" when nothing is known of the error;
/// an exact value has four digits and no interval.
std::string formatInterval(const Interval& interval);

/// A number with `digits` significant digits, without exponent for 1e-4 .. 1e7, thousands apart by a thin space.
std::string formatNumber(double value, int digits = 4);

/// A number with `decimals` decimals, thousands apart by a thin space.
std::string formatFixed(double value, int decimals);

/// The value, or NaN where it is withheld: nothing is known of its error.
[[nodiscard]] double knownLux(const Interval& lux);

/// One value of a grid in the plan: whole lux from 10 lx, else one decimal; "–" when not finite.
std::string formatGridLux(double lux);

/// "850 ms", "42 s", "3 min 20 s", "2 h 05 min".
std::string formatSeconds(double seconds);

/// 1 234 567 with thin spaces.
std::string formatCount(unsigned long long count);

/// "1.6 %".
std::string formatPercent(double fraction);

}  // namespace luxdeck
