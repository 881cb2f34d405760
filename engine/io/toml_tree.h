#pragma once

#include "engine/core/result.h"

#include <toml++/toml.h>

#include <string>
#include <string_view>

namespace luxdeck {

/// Reads TOML as a tree; keys of more than 64 parts are refused, since they end programs (lineOfDeepKey).
///
/// name    of the file, for messages; empty: they say "line 12" alone
/// errors  Parse: syntax
Result<toml::table> tomlTree(std::string_view bytes, const std::string& name);

}  // namespace luxdeck
