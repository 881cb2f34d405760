#pragma once

#include <optional>
#include <string_view>

namespace luxdeck {

/// The line of the first key of more than `most` parts (a.b.c has 3), if there is one. toml++ limits the depth of
/// arrays and inline tables but not that of dotted keys, and clears nested tables by recursion: a key of 10^5 parts
/// would end the program.
std::optional<int> lineOfDeepKey(std::string_view toml, int most);

}  // namespace luxdeck
