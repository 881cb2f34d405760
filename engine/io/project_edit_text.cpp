#include "engine/io/project_edit_source.h"
#include "engine/io/toml_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace luxdeck {

namespace {

Error at(const toml::node& node, std::string message) {
    return {ErrorCode::Unsupported, std::move(message), fmt::format("line {}", std::max(1, static_cast<int>(node.source().begin.line)))};
}

std::string titleOf(const TomlPlace& place) { return place.section.empty() ? "the top level" : fmt::format("[{}] {}", place.section, place.index + 1); }

/// Written with a value behind its key, not as tables with headers or keys with dots.
bool isPlainValue(const toml::node& node) {
    if (const auto* table = node.as_table()) return table->is_inline();
    const auto* array = node.as_array();
    if (array == nullptr || array->empty()) return true;
    const auto* first = (*array)[0].as_table();
    return first == nullptr || first->is_inline();
}

/// The document that a value is the only one of.
Result<toml::table> treeOf(const KeyChange& change) {
    auto tree = tomlTree(fmt::format("value = {}\n", change.value->text()), {});
    if (!tree) return Error{ErrorCode::InvalidArgument, fmt::format("{}: {}", change.key, tree.error().message), {}};
    return tree;
}

std::string_view withoutLastBreak(std::string_view text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

}  // namespace

/// One making of a text: splices for the bytes, and beside them the tree that is wanted, which both have to agree.
class ProjectEditing {
public:
    explicit ProjectEditing(const ProjectEdit& edit) : edit_(edit), source_(*edit.source_), layout_(source_.layout), wanted_(source_.tree) {}

    Result<std::string> run() {
        for (const auto& [place, keys] : edit_.changed_)
            if (auto done = changeTable(place, keys); !done) return done.error();
        if (auto done = replaceTables(); !done) return done.error();
        for (const auto& added : edit_.added_)
            if (auto done = addTable(added); !done) return done.error();
        for (auto& removal : layout_.removals(gone_)) splices_.push_back(std::move(removal));
        auto text = source_.text;
        if (!splice(text, std::move(splices_))) return Error{ErrorCode::InvalidArgument, "the same place is changed twice, expected one change of it", {}};
        return checked(std::move(text));
    }

private:
    [[nodiscard]] Error missing(const TomlPlace& place) const {
        return {ErrorCode::InvalidArgument,
                fmt::format("there is no [[{}]] {}, expected one of {}", place.section, place.index + 1, edit_.count(place.section)), {}};
    }

    // ---- keys of a table ----
    Result<void> changeTable(const TomlPlace& place, const std::vector<KeyChange>& keys) {
        const auto* table = tomlTableAt(source_.tree, place);
        if (table == nullptr && place.index == 0 && !source_.tree.contains(place.section)) return addSection(place.section, keys);
        if (table == nullptr) return missing(place);
        std::vector<const KeyChange*> added;
        for (const auto& change : keys) {
            const auto* node = table->get(change.key);
            if (auto noted = want(place, change); !noted) return noted;
            if (node == nullptr && change.value) added.push_back(&change);
            if (node == nullptr) continue;
            if (!change.value) removeKey(*table, *node);
            else if (auto done = overwrite(*node, change); !done) return done;
        }
        return added.empty() ? Result<void>() : addKeys(place, *table, added);
    }

    Result<void> want(const TomlPlace& place, const KeyChange& change) {
        auto& table = *tomlTableAt(wanted_, place);
        if (!change.value) {
            table.erase(change.key);
            return {};
        }
        const auto value = treeOf(change);
        if (!value) return value.error();
        table.insert_or_assign(change.key, *value->get("value"));
        return {};
    }

    Result<void> overwrite(const toml::node& node, const KeyChange& change) {
        if (!isPlainValue(node)) return at(node, fmt::format("{} is written as a table of its own, expected {} = ...", change.key, change.key));
        splices_.push_back({layout_.offset(node.source().begin), layout_.offset(node.source().end), change.value->text()});
        return {};
    }

    void removeKey(const toml::table& table, const toml::node& node) {
        if (table.is_inline()) return removeInlineKey(table, node);
        for (const auto i : layout_.statements(node))
            if (layout_.lines()[i].kind == TomlLine::Kind::Header) removeBlock(layout_.block(i));
            else gone_.insert(i);
    }

    void removeBlock(const TomlLayout::Block& block) {
        for (auto i = block.first; i <= block.last; ++i) gone_.insert(i);
    }

    /// With the comma that it no longer needs.
    void removeInlineKey(const toml::table& table, const toml::node& node) {
        struct Entry {
            std::size_t begin, end;
            const toml::node* node;
        };
        std::vector<Entry> entries;
        for (const auto& [key, value] : table)
            entries.push_back({layout_.offset(key.source().begin), layout_.offset(value.source().end), &value});
        std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.begin < b.begin; });
        const auto entry = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.node == &node; });
        if (entry + 1 != entries.end()) splices_.push_back({entry->begin, (entry + 1)->begin, {}});
        else splices_.push_back({entry == entries.begin() ? entry->begin : (entry - 1)->end, entry->end, {}});
    }

    Result<void> addKeys(const TomlPlace& place, const toml::table& table, const std::vector<const KeyChange*>& added) {
        std::vector<std::string> entries;
        for (const auto* change : added) entries.push_back(fmt::format("{} = {}", tomlKey(change->key), change->value->text()));
        if (table.is_inline()) {
            const auto brace = layout_.offset(table.source().end) - 1;
            const auto before = source_.text.find_last_not_of(" \t", brace - 1) + 1;
            splices_.push_back({before, before, fmt::format("{}{}", table.empty() ? " " : ", ", fmt::join(entries, ", "))});
            return {};
        }
        if (!place.section.empty() && !layout_.hasHeader(table))
            return at(table, fmt::format("{} is written by keys with dots, expected [{}]", place.section, place.section));
        addLines(place, table, entries);
        return {};
    }

    /// After the last key line that stays, indented as it is.
    void addLines(const TomlPlace& place, const toml::table& table, const std::vector<std::string>& entries) {
        const auto& lines = layout_.lines();
        const bool root = place.section.empty();
        const auto header = root ? 0 : layout_.statementOf(table);
        std::optional<std::size_t> after;
        if (!root) after = header;
        for (auto i = root ? 0 : header + 1; i < lines.size() && lines[i].kind != TomlLine::Kind::Header; ++i)
            if (lines[i].kind == TomlLine::Kind::Key && !gone_.contains(i)) after = i;
        std::string text;
        if (!after) {
            for (const auto& entry : entries) text += fmt::format("{}{}", entry, layout_.lineBreak());
            const auto top = lines.empty() ? source_.text.size() : lines.front().begin;
            return splices_.push_back({top, top, text});
        }
        const auto begin = lines[*after].begin;
        const auto indent = source_.text.substr(begin, source_.text.find_first_not_of(" \t", begin) - begin);
        for (const auto& entry : entries) text += fmt::format("{}{}{}", layout_.lineBreak(), indent, entry);
        splices_.push_back({lines[*after].end, lines[*after].end, text});
    }

    // ---- whole tables ----
    [[nodiscard]] std::string keyLines(const std::vector<KeyChange>& keys) const {
        std::string text;
        for (const auto& change : keys)
            if (change.value) text += fmt::format("{}{} = {}", layout_.lineBreak(), tomlKey(change.key), change.value->text());
        return text;
    }

    Result<void> addSection(const std::string& section, const std::vector<KeyChange>& keys) {
        wanted_.insert_or_assign(section, toml::table{});
        for (const auto& change : keys)
            if (auto noted = want({section, 0}, change); !noted) return noted;
        addAtEnd(fmt::format("[{}]{}", tomlKey(section), keyLines(keys)));
        return {};
    }

    void addAtEnd(const std::string& table) {
        const auto& text = source_.text;
        const auto eol = layout_.lineBreak();
        const bool closed = addedAtEnd_ || text.empty() || text.back() == '\n';
        addedAtEnd_ = true;
        splices_.push_back({text.size(), text.size(), fmt::format("{}{}{}{}", closed ? "" : eol, text.empty() ? "" : eol, table, eol)});
    }

    /// The text of a table by itself, with changes, without the comments above it and a last line break.
    Result<std::string> copyOf(const TomlPlace& place, const std::vector<KeyChange>& changes) const {
        const auto* table = tomlTableAt(source_.tree, place);
        if (table == nullptr) return missing(place);
        if (!layout_.hasHeader(*table)) return at(*table, fmt::format("{} is written in one array, expected [[{}]] tables", place.section, place.section));
        std::string alone;
        for (const auto& block : layout_.blocks(*table))
            for (auto i = block.header; i <= block.last; ++i)
                alone += fmt::format("{}{}", layout_.text().substr(layout_.lines()[i].begin, layout_.lines()[i].end - layout_.lines()[i].begin), layout_.lineBreak());
        auto edit = ProjectEdit::of(std::move(alone));
        if (!edit) return at(*table, fmt::format("{} cannot be copied: {}", titleOf(place), edit.error().message));
        for (const auto& change : changes) edit->changed_[{place.section, 0}].push_back(change);
        auto text = edit->text();
        if (!text) return at(*table, fmt::format("{}: {}", titleOf(place), text.error().message));
        return std::string(withoutLastBreak(*text));
    }

    /// The table that a text by itself says.
    Result<toml::table> tableOf(const std::string& text, const std::string& section) const {
        auto tree = tomlTree(text, {});
        if (!tree) return Error{ErrorCode::InvalidArgument, fmt::format("[[{}]]: {}", section, tree.error().message), {}};
        const auto* table = tomlTableAt(*tree, {section, 0});
        if (table == nullptr) return Error{ErrorCode::Internal, fmt::format("[[{}]]: no table was made", section), {}};
        return toml::table(*table);
    }

    Result<void> replaceTables() {
        for (auto at = edit_.replaced_.rbegin(); at != edit_.replaced_.rend(); ++at)  // from the back: places in wanted_ stay
            if (auto done = replaceTable(at->first, at->second); !done) return done;
        return {};
    }

    Result<void> replaceTable(const TomlPlace& place, const std::vector<std::vector<KeyChange>>& copies) {
        const auto* table = tomlTableAt(source_.tree, place);
        auto* all = wanted_[place.section].as_array();
        if (table == nullptr || all == nullptr) return missing(place);
        if (!layout_.hasHeader(*table)) return at(*table, fmt::format("{} is written in one array, expected [[{}]] tables", place.section, place.section));
        std::string text;
        all->erase(all->begin() + static_cast<std::ptrdiff_t>(place.index));
        for (std::size_t i = 0; i < copies.size(); ++i) {
            const auto copy = copyOf(place, copies[i]);
            if (!copy) return copy.error();
            const auto made = tableOf(*copy, place.section);
            if (!made) return made.error();
            all->insert(all->begin() + static_cast<std::ptrdiff_t>(place.index + i), *made);
            text += fmt::format("{}{}{}", text.empty() ? "" : layout_.lineBreak(), text.empty() ? "" : layout_.lineBreak(), *copy);
        }
        if (all->empty()) wanted_.erase(place.section);
        const auto blocks = layout_.blocks(*table);
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            if (i > 0 || copies.empty()) removeBlock(blocks[i]);
            else splices_.push_back({layout_.lines()[blocks[i].header].begin, layout_.lines()[blocks[i].last].end, text});
        }
        return {};
    }

    Result<void> addTable(const ProjectEdit::Added& added) {
        auto text = added.copyOf ? copyOf(*added.copyOf, added.keys)
                                 : Result<std::string>(fmt::format("[[{}]]{}", tomlKey(added.section), keyLines(added.keys)));
        if (!text) return text.error();
        const auto made = tableOf(*text, added.section);
        if (!made) return made.error();
        if (!wanted_.contains(added.section)) wanted_.insert_or_assign(added.section, toml::array{});
        auto* all = wanted_[added.section].as_array();
        if (all == nullptr || !isTableArray(added.section))
            return at(*source_.tree.get(added.section), fmt::format("{} is not written as [[{}]] tables, expected those", added.section, added.section));
        all->push_back(*made);
        if (const auto* last = lastKept(added.section)) {
            const auto end = layout_.lines()[layout_.blocks(*last).back().last].end;
            splices_.push_back({end, end, fmt::format("{}{}{}", layout_.lineBreak(), layout_.lineBreak(), *text)});
        } else {
            addAtEnd(*text);
        }
        return {};
    }

    [[nodiscard]] bool isTableArray(const std::string& section) const {
        const auto* node = source_.tree.get(section);
        if (node == nullptr) return true;
        const auto* array = node->as_array();
        return array != nullptr && !array->empty() && !isPlainValue(*array);
    }

    [[nodiscard]] const toml::table* lastKept(const std::string& section) const {
        for (auto i = edit_.count(section); i-- > 0;) {
            const auto gone = edit_.replaced_.find({section, i});
            if (gone == edit_.replaced_.end() || !gone->second.empty()) return tomlTableAt(source_.tree, {section, i});
        }
        return nullptr;
    }

    // ---- the end ----
    [[nodiscard]] Result<std::string> checked(std::string text) const {
        const auto tree = tomlTree(text, {});
        if (tree && sameToml(*tree, wanted_)) return text;
        const auto line = edit_.changed_.empty() ? 1 : lineOf(edit_.changed_.begin()->first);
        return Error{ErrorCode::Unsupported, "is laid out in a way that this change cannot follow, expected a header and one key a line", fmt::format("line {}", line)};
    }

    [[nodiscard]] int lineOf(const TomlPlace& place) const {
        const auto* table = tomlTableAt(source_.tree, place);
        return table != nullptr ? std::max(1, static_cast<int>(table->source().begin.line)) : 1;
    }

    const ProjectEdit& edit_;
    const ProjectEdit::Source& source_;
    const TomlLayout& layout_;
    toml::table wanted_;
    std::vector<TomlSplice> splices_;
    std::set<std::size_t> gone_;    // statements that are taken out whole
    bool addedAtEnd_ = false;
};

Result<std::string> ProjectEdit::text() const { return ProjectEditing(*this).run(); }

}  // namespace luxdeck
