#include "engine/io/toml_layout.h"

#include <algorithm>
#include <iterator>

namespace luxdeck {

namespace {

using Kind = TomlLine::Kind;

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }  // inside a character of UTF-8

}  // namespace

TomlLayout::TomlLayout(std::string_view text) : text_(text), lines_(tomlLines(text)), lineBreak_("\n") {
    // A byte order mark is no column.
    lineBegins_.push_back(lines_.empty() ? 0 : lines_.front().begin);
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') lineBegins_.push_back(i + 1);
    if (const auto first = text.find('\n'); first != std::string_view::npos && first > 0 && text[first - 1] == '\r') lineBreak_ = "\r\n";
}

std::size_t TomlLayout::offset(const toml::source_position& position) const {
    if (position.line < 1 || position.line > lineBegins_.size()) return text_.size();
    std::size_t at = lineBegins_[position.line - 1];
    for (auto column = position.column; column > 1 && at < text_.size(); --column)
        do ++at;
        while (at < text_.size() && continues(text_[at]));
    return at;
}

std::size_t TomlLayout::statementAt(std::size_t offset) const {
    const auto after = std::upper_bound(lines_.begin(), lines_.end(), offset, [](std::size_t at, const TomlLine& line) { return at < line.begin; });
    return after == lines_.begin() ? 0 : static_cast<std::size_t>(after - lines_.begin()) - 1;
}

bool TomlLayout::hasHeader(const toml::table& table) const {
    if (table.is_inline() || lines_.empty()) return false;
    return lines_[statementOf(table)].kind == Kind::Header;
}

TomlLayout::Block TomlLayout::block(std::size_t header) const {
    Block block{header, header, header, header};
    while (block.first > 0 && lines_[block.first - 1].kind == Kind::Comment) --block.first;
    for (auto i = header + 1; i < lines_.size() && lines_[i].kind != Kind::Header; ++i)
        if (lines_[i].kind == Kind::Key) block.lastKey = i;
    block.last = block.lastKey;
    auto below = block.last + 1;
    while (below < lines_.size() && lines_[below].kind == Kind::Comment) ++below;
    if (below == lines_.size() || lines_[below].kind == Kind::Blank) block.last = below - 1;  // else they are the next header's
    return block;
}

void TomlLayout::collect(const toml::node& node, std::vector<std::size_t>& out) const {
    if (node.source().begin.line > 0) out.push_back(statementOf(node));
    if (const auto* table = node.as_table())
        for (const auto& [key, value] : *table) collect(value, out);
    if (const auto* array = node.as_array())
        for (const auto& item : *array) collect(item, out);
}

std::vector<std::size_t> TomlLayout::statements(const toml::node& node) const {
    std::vector<std::size_t> out;
    collect(node, out);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

std::vector<TomlLayout::Block> TomlLayout::blocks(const toml::table& table) const {
    std::vector<Block> out;
    for (const auto i : statements(table))
        if (lines_[i].kind == Kind::Header) out.push_back(block(i));
    return out;
}

std::vector<TomlSplice> TomlLayout::removals(const std::set<std::size_t>& statements) const {
    const auto gone = [&](std::size_t i) { return statements.contains(i); };
    const auto blank = [&](std::size_t i) { return i < lines_.size() && lines_[i].kind == Kind::Blank; };
    std::vector<TomlSplice> out;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (!gone(i)) continue;
        auto first = i, last = i;
        const bool gapAbove = first == 0 || blank(first - 1);
        while (gone(last + 1) || (gapAbove && blank(last + 1))) ++last;
        if (last + 1 == lines_.size())
            while (first > 0 && blank(first - 1)) --first;
        out.push_back({lines_[first].begin, lines_[last].next, {}});
        i = last;
    }
    return out;
}

bool splice(std::string& text, std::vector<TomlSplice> splices) {
    std::stable_sort(splices.begin(), splices.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
    std::string out;
    std::size_t at = 0;
    for (const auto& one : splices) {
        if (one.begin < at) return false;
        out.append(text, at, one.begin - at);
        out += one.text;
        at = one.end;
    }
    out.append(text, at);
    text = std::move(out);
    return true;
}

}  // namespace luxdeck
