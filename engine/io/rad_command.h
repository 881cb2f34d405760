#pragma once

#include "engine/core/result.h"
#include "engine/io/rad_primitive.h"
#include "engine/io/rad_text.h"

#include <span>
#include <string>
#include <vector>

namespace luxdeck::rad {

/// The words of one program of a command line, the program's name first.
using CommandWords = std::vector<std::string>;

/// Cuts a command line into programs, which pipes join, and words. Quotes and backslashes mean what they mean to a
/// shell; everything else that a shell would act upon (; & < > ` $ ( ) and globs) is refused by name.
///
/// errors  Unsupported, Parse: file:line of the command
Result<std::vector<CommandWords>> splitCommand(const Command& command);

/// The words of one line, quotes taken off, without pipes: for a file of arguments.
Result<CommandWords> splitWords(const std::string& line, const Place& place);

}  // namespace luxdeck::rad
