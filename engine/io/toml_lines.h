#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace luxdeck {

/// A statement of a TOML text with the whole of its lines: a value may go over several.
struct TomlLine {
    enum class Kind { Blank, Comment, Header, Key };
    Kind kind = Kind::Blank;
    std::size_t begin = 0;  ///< of its first line [byte]
    std::size_t end = 0;    ///< of its last, before the line break; comments behind it are within
    std::size_t next = 0;   ///< begin of what follows
};

/// The statements of a text that is known to be TOML, in order; they cover it without gaps.
std::vector<TomlLine> tomlLines(std::string_view toml);

}  // namespace luxdeck
