#pragma once

#include "cli/command.h"

#include <string>
#include <vector>

namespace luxdeck::cli {

/// Whether a file is neither project, scene nor photometry, but something that these name (weather, a picture, a
/// material library), or nothing that is read at all. By its name, else by what it begins with.
bool isAside(const std::string& path);

/// `luxdeck check` of such files: what each one is, whether it reads, and where it belongs.
Exit checkAside(const std::vector<std::string>& files, const Context& context);

}  // namespace luxdeck::cli
