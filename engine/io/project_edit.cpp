#include "engine/io/project_edit.h"

#include "engine/io/project_edit_source.h"
#include "engine/io/toml_tree.h"

#include <cmath>
#include <utility>

namespace luxdeck {

const toml::table* tomlTableAt(const toml::table& root, const TomlPlace& place) {
    if (place.section.empty()) return place.index == 0 ? &root : nullptr;
    const auto* node = root.get(place.section);
    if (node == nullptr) return nullptr;
    if (const auto* table = node->as_table()) return place.index == 0 ? table : nullptr;
    const auto* array = node->as_array();
    return array != nullptr && place.index < array->size() ? (*array)[place.index].as_table() : nullptr;
}

bool sameToml(const toml::node& a, const toml::node& b) {
    if (a.type() != b.type()) return false;
    if (const auto* table = a.as_table()) {
        const auto& other = *b.as_table();
        if (table->size() != other.size()) return false;
        for (const auto& [key, value] : *table) {
            const auto* match = other.get(key.str());
            if (match == nullptr || !sameToml(value, *match)) return false;
        }
        return true;
    }
    if (const auto* array = a.as_array()) {
        const auto& other = *b.as_array();
        if (array->size() != other.size()) return false;
        for (std::size_t i = 0; i < array->size(); ++i)
            if (!sameToml((*array)[i], other[i])) return false;
        return true;
    }
    if (const auto* number = a.as_floating_point()) {
        const double x = number->get(), y = b.as_floating_point()->get();
        return x == y || (std::isnan(x) && std::isnan(y));
    }
    return a.visit([&](const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (toml::is_value<Value>) return value.get() == b.ref<Value>();
        else return false;
    });
}

namespace {

const toml::node* nodeAt(const toml::table& root, const TomlPlace& place, std::string_view path) {
    const auto* table = tomlTableAt(root, place);
    while (table != nullptr) {
        const auto dot = path.find('.');
        const auto* node = table->get(path.substr(0, dot));
        if (node == nullptr || dot == std::string_view::npos) return node;
        table = node->as_table();
        path.remove_prefix(dot + 1);
    }
    return nullptr;
}

/// The items of an array that are all of a type; empty: it is something else.
template <class T>
std::vector<T> itemsOf(const toml::node* node) {
    std::vector<T> out;
    if (node == nullptr || !node->is_array()) return out;
    for (const auto& item : *node->as_array()) {
        const auto value = item.value<T>();
        if (!value) return {};
        out.push_back(*value);
    }
    return out;
}

}  // namespace

Result<ProjectEdit> ProjectEdit::of(std::string text) {
    auto tree = tomlTree(text, {});
    if (!tree) return tree.error();
    ProjectEdit edit;
    edit.source_ = std::make_shared<const Source>(std::move(text), *std::move(tree));
    return edit;
}

std::size_t ProjectEdit::count(std::string_view section) const {
    const auto* node = source_->tree.get(section);
    if (node == nullptr) return 0;
    return node->is_array() ? node->as_array()->size() : node->is_table() ? 1 : 0;
}

bool ProjectEdit::has(const TomlPlace& place, std::string_view path) const { return nodeAt(source_->tree, place, path) != nullptr; }

std::optional<std::string> ProjectEdit::string(const TomlPlace& place, std::string_view path) const {
    const auto* node = nodeAt(source_->tree, place, path);
    return node != nullptr ? node->value<std::string>() : std::nullopt;
}

std::optional<double> ProjectEdit::number(const TomlPlace& place, std::string_view path) const {
    const auto* node = nodeAt(source_->tree, place, path);
    return node != nullptr && node->is_number() ? node->value<double>() : std::nullopt;
}

std::vector<double> ProjectEdit::numbers(const TomlPlace& place, std::string_view path) const {
    return itemsOf<double>(nodeAt(source_->tree, place, path));
}

std::vector<std::string> ProjectEdit::strings(const TomlPlace& place, std::string_view path) const {
    return itemsOf<std::string>(nodeAt(source_->tree, place, path));
}

std::optional<std::size_t> ProjectEdit::find(std::string_view section, std::string_view key, std::string_view value) const {
    for (std::size_t i = 0; i < count(section); ++i)
        if (string({std::string(section), i}, key) == value) return i;
    return std::nullopt;
}

void ProjectEdit::set(const TomlPlace& place, const std::string& key, TomlValue value) {
    changed_[place].push_back({key, std::move(value)});
}

void ProjectEdit::remove(const TomlPlace& place, const std::string& key) { changed_[place].push_back({key, std::nullopt}); }

void ProjectEdit::append(const std::string& section, std::vector<KeyChange> entries) {
    added_.push_back({section, std::nullopt, std::move(entries)});
}

void ProjectEdit::appendCopy(const TomlPlace& of, std::vector<KeyChange> changes) {
    added_.push_back({of.section, of, std::move(changes)});
}

void ProjectEdit::removeTable(const TomlPlace& place) { replaced_[place] = {}; }

void ProjectEdit::replaceTable(const TomlPlace& place, std::vector<std::vector<KeyChange>> copies) {
    replaced_[place] = std::move(copies);
}

}  // namespace luxdeck
