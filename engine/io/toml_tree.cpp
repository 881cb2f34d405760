#include "engine/io/toml_tree.h"

#include "engine/io/toml_depth.h"

#include <fmt/format.h>

#include <algorithm>

namespace luxdeck {

namespace {

constexpr int kMaxKeyParts = 64;

std::string placeOf(const std::string& name, int line) { return name.empty() ? fmt::format("line {}", line) : fmt::format("{}:{}", name, line); }

}  // namespace

Result<toml::table> tomlTree(std::string_view bytes, const std::string& name) {
    if (const auto line = lineOfDeepKey(bytes, kMaxKeyParts))
        return Error{ErrorCode::Parse, fmt::format("a key of more than {} parts, expected names without dots", kMaxKeyParts), placeOf(name, *line)};
    try {
        return toml::parse(bytes, std::string_view(name));
    } catch (const toml::parse_error& e) {
        return Error{ErrorCode::Parse, std::string(e.description()), placeOf(name, std::max(1, static_cast<int>(e.source().begin.line)))};
    }
}

}  // namespace luxdeck
