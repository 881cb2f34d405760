#pragma once

#include "cli/command.h"

#include <string>
#include <vector>

namespace luxdeck::cli {

/// By its name: .ies or .ldt, whatever the case.
bool isPhotometric(const std::string& path);

/// `luxdeck check` of photometric files: what was measured on each, repaired and refused. A refused file does not
/// keep the others from being checked.
///
/// drawing  where the sheet with the curves goes; empty: nowhere. Of one file alone
Exit checkPhotometry(const std::vector<std::string>& files, const std::string& drawing, const Context& context);

}  // namespace luxdeck::cli
