#include "engine/io/toml_depth.h"

#include <algorithm>
#include <cstddef>

namespace luxdeck {

std::size_t endOfTomlString(std::string_view toml, std::size_t at) {
    const char quote = toml[at];
    const bool literal = quote == '\'';
    const std::string_view triple = literal ? "'''" : R"(""")";
    const bool multiline = toml.substr(at, 3) == triple;
    for (std::size_t i = at + (multiline ? 3 : 1); i < toml.size(); ++i) {
        if (toml[i] == '\\' && !literal) {
            ++i;
        } else if (multiline && toml.substr(i, 3) == triple) {
            i += 3;  // up to two quotes more belong to the text
            for (int extra = 0; extra < 2 && i < toml.size() && toml[i] == quote; ++extra) ++i;
            return i;
        } else if (!multiline && (toml[i] == quote || toml[i] == '\n')) {
            return toml[i] == quote ? i + 1 : i;
        }
    }
    return toml.size();
}

std::optional<int> lineOfDeepKey(std::string_view toml, int most) {
    int line = 1;
    int parts = 1;
    for (std::size_t i = 0; i < toml.size();) {
        const char c = toml[i];
        if (c == '"' || c == '\'') {
            const auto end = std::min(endOfTomlString(toml, i), toml.size());
            line += static_cast<int>(std::count(toml.begin() + static_cast<std::ptrdiff_t>(i),
                                                toml.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
            i = end;
            continue;
        }
        if (c == '#') {
            i = std::min(toml.find('\n', i), toml.size());
            continue;
        }
        if (c == '\n') ++line;
        if (c == '.' && ++parts > most) return line;
        if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) parts = 1;
        ++i;
    }
    return std::nullopt;
}

}  // namespace luxdeck
