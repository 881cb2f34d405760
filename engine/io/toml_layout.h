#pragma once

#include "engine/io/toml_lines.h"

#include <toml++/toml.h>

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck {

/// A range of bytes, and what comes instead of it. Empty range: an insertion; empty text: a removal.
struct TomlSplice {
    std::size_t begin = 0, end = 0;
    std::string text;
};

/// Where the nodes of a parsed TOML text stand in it.
class TomlLayout {
public:
    explicit TomlLayout(std::string_view text);

    /// Statements of a header: itself with the comments right above it, its keys, and comments right below the last.
    struct Block {
        std::size_t first = 0, header = 0, lastKey = 0, last = 0;  // indices into lines(); lastKey: of the header, if it has none
    };

    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] const std::vector<TomlLine>& lines() const { return lines_; }
    [[nodiscard]] std::string_view lineBreak() const { return lineBreak_; }

    [[nodiscard]] std::size_t offset(const toml::source_position& position) const;
    /// Index into lines() of the statement that holds a byte.
    [[nodiscard]] std::size_t statementAt(std::size_t offset) const;
    [[nodiscard]] std::size_t statementOf(const toml::node& node) const { return statementAt(offset(node.source().begin)); }

    /// A table that has a header of its own, [a] or [[a]].
    [[nodiscard]] bool hasHeader(const toml::table& table) const;
    [[nodiscard]] Block block(std::size_t header) const;
    /// Of a table and all tables below it, in the order of the text.
    [[nodiscard]] std::vector<Block> blocks(const toml::table& table) const;
    /// All statements that say something of a node, or of what is in it; ascending, each once.
    [[nodiscard]] std::vector<std::size_t> statements(const toml::node& node) const;

    /// Takes out whole statements, and of the blank lines around them one side.
    [[nodiscard]] std::vector<TomlSplice> removals(const std::set<std::size_t>& statements) const;

private:
    void collect(const toml::node& node, std::vector<std::size_t>& out) const;

    std::string_view text_;
    std::vector<TomlLine> lines_;
    std::vector<std::size_t> lineBegins_;  // of every line of the text, statements of several lines too [byte]
    std::string_view lineBreak_;
};

/// Does all splices. Returns false, and leaves the text alone, when two of them overlap.
bool splice(std::string& text, std::vector<TomlSplice> splices);

}  // namespace luxdeck
