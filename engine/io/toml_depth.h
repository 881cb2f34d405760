#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace luxdeck {

/// The line of the first key of more than `most` parts (a.b.c has 3), if there is one. toml++ limits the depth of
/// arrays and inline tables but not that of dotted keys, and clears nested tables by recursion: a key of 10^5 parts
/// would end the program.
std::optional<int> lineOfDeepKey(std::string_view toml, int most);

/// Where the string that begins at `at` (a quote) ends: one past its last quote, or the end of its line if it is not closed.
std::size_t endOfTomlString(std::string_view toml, std::size_t at);

}  // namespace luxdeck
