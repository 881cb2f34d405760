#pragma once

#include "engine/io/epw.h"

namespace luxdeck {

/// Reads the WEA file of gendaymtx and Daysim. Its rows are named by the middle of their interval; longitude (in
/// degrees) and time zone (likewise) count westwards.
///
/// name    of the file, for messages
/// errors  Parse: file:line, what was seen, what was expected
Result<Weather> readWea(std::string_view bytes, const std::string& name);

}  // namespace luxdeck
