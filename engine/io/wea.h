#pragma once

#include "engine/io/epw.h"

namespace luxdeck {

/// Reads the WEA file of gendaymtx and Daysim. Its rows are named by the middle of their interval; longitude (in
/// degrees) and time zone (likewise) count westwards. Hours go up to 24.5: those above 24 are the next day's, after the
/// last day of the year the first one's. A field that cannot be read costs the hours of its row alone.
///
/// name    of the file, for messages
/// errors  Parse: file:line, what was seen, what was expected
Result<Weather> readWea(std::string_view bytes, const std::string& name);

/// EPW or WEA, by what it begins with, whatever its name is.
Result<Weather> readWeatherFile(std::string_view bytes, const std::string& name);

}  // namespace luxdeck
