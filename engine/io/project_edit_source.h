#pragma once

#include "engine/io/project_edit.h"
#include "engine/io/toml_layout.h"

#include <toml++/toml.h>

#include <string>

namespace luxdeck {

/// The text that is edited, as a tree and as it is laid out. Stays where it is made: the layout points into it.
struct ProjectEdit::Source {
    Source(std::string given, toml::table parsed) : text(std::move(given)), tree(std::move(parsed)), layout(text) {}
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    std::string text;
    toml::table tree;
    TomlLayout layout;
};

/// Null: there is no such table.
const toml::table* tomlTableAt(const toml::table& root, const TomlPlace& place);
inline toml::table* tomlTableAt(toml::table& root, const TomlPlace& place) {
    return const_cast<toml::table*>(tomlTableAt(static_cast<const toml::table&>(root), place));
}

/// Whether two nodes hold the same; NaN is itself.
bool sameToml(const toml::node& a, const toml::node& b);

}  // namespace luxdeck
