#pragma once

#include "cli/command.h"
#include "cli/load.h"

#include <string>

namespace luxdeck::cli {

Command addFurniture(CLI::App& program);
Command addShade(CLI::App& program);

/// Takes an object out of the scene and makes the rest ready for light.
///
/// errors  InvalidArgument: no such object
Result<void> removeObject(Loaded& loaded, const std::string& name);

}  // namespace luxdeck::cli
