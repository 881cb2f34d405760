#include "engine/io/toml_lines.h"

#include "engine/io/toml_depth.h"

#include <algorithm>

namespace luxdeck {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// The line break that ends what begins at `at`, or the end of the text.
std::size_t endOfStatement(std::string_view toml, std::size_t at) {
    int depth = 0;
    while (at < toml.size()) {
        const char c = toml[at];
        if (c == '\n' && depth <= 0) return at;
        if (c == '"' || c == '\'') {
            at = std::min(endOfTomlString(toml, at), toml.size());
            continue;
        }
        if (c == '#') {
            at = std::min(toml.find('\n', at), toml.size());
            continue;
        }
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        ++at;
    }
    return toml.size();
}

TomlLine::Kind kindAt(std::string_view toml, std::size_t at) {
    if (at >= toml.size() || toml[at] == '\n' || toml[at] == '\r') return TomlLine::Kind::Blank;
    if (toml[at] == '#') return TomlLine::Kind::Comment;
    return toml[at] == '[' ? TomlLine::Kind::Header : TomlLine::Kind::Key;
}

}  // namespace

std::vector<TomlLine> tomlLines(std::string_view toml) {
    std::vector<TomlLine> lines;
    std::size_t at = toml.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
    while (at < toml.size()) {
        const auto first = std::min(toml.find_first_not_of(" \t", at), toml.size());
        const auto lineBreak = endOfStatement(toml, first);
        const bool carriage = lineBreak > first && toml[lineBreak - 1] == '\r';
        lines.push_back({kindAt(toml, first), at, lineBreak - (carriage ? 1 : 0), std::min(lineBreak + 1, toml.size())});
        at = lines.back().next;
    }
    return lines;
}

}  // namespace luxdeck
