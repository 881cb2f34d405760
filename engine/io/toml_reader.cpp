#include "engine/io/toml_reader.h"

#include "engine/io/toml_tree.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace luxdeck {

struct TomlSource {
    std::string file;
    Diagnostics* diagnostics;
};

namespace {

const toml::table& asTable(const void* node) { return *static_cast<const toml::table*>(node); }

int lineOf(const toml::node& node) { return std::max(1, static_cast<int>(node.source().begin.line)); }

/// What the user wrote, in words: "a string", "an integer".
std::string_view typeName(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table: return "a table";
        case toml::node_type::array: return "an array";
        case toml::node_type::string: return "a string";
        case toml::node_type::integer: return "an integer";
        case toml::node_type::floating_point: return "a number";
        case toml::node_type::boolean: return "a boolean";
        case toml::node_type::date: return "a date";
        case toml::node_type::time: return "a time";
        case toml::node_type::date_time: return "a date and time";
        default: return "nothing";
    }
}

/// A TOML date literal is as good as a string: date = 2026-11-22.
std::optional<std::string> dateText(const toml::node& node) {
    const auto* date = node.as_date();
    if (date == nullptr) return std::nullopt;
    const auto& d = date->get();
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(d.year), static_cast<int>(d.month), static_cast<int>(d.day));
}

/// The numbers of an array, if it holds exactly `count` of them.
std::optional<std::vector<double>> numbersOf(const toml::node& node, std::size_t count) {
    const auto* array = node.as_array();
    if (array == nullptr || array->size() != count) return std::nullopt;
    std::vector<double> values;
    for (const auto& item : *array) {
        if (!item.is_number()) return std::nullopt;
        values.push_back(*item.value<double>());
    }
    return values;
}

}  // namespace

void Diagnostics::error(ErrorCode code, const std::string& file, int line, std::string message) {
    if (first_ && (file != file_ || line >= line_)) return;
    first_ = Error{code, std::move(message), fmt::format("{}:{}", file, line)};
    file_ = file;
    line_ = line;
}

bool NumberRange::contains(double value) const {
    if (!std::isfinite(value)) return false;
    const bool aboveLow = lowExcluded ? value > low : value >= low;
    const bool belowHigh = highExcluded ? value < high : value <= high;
    return aboveLow && belowHigh;
}

std::string NumberRange::text() const {
    const bool bottom = low > std::numeric_limits<double>::lowest();
    const bool top = high < std::numeric_limits<double>::max();
    if (!bottom && !top) return "a finite number";
    const std::string lower = fmt::format("{}{}", lowExcluded ? "> " : (top ? "" : ">= "), low);
    const std::string upper = fmt::format("{}{}", highExcluded ? "< " : (bottom ? "" : "<= "), high);
    if (!top) return lower;
    return bottom ? fmt::format("{} .. {}", lower, upper) : upper;
}

TomlTable::TomlTable(const void* node, const TomlSection& section, const TomlSource& source)
    : node_(node), section_(&section), source_(&source) {
    refuseUnknownKeys();
}

bool TomlTable::isPastFirstError() const {
    return source_->diagnostics->hasErrorBefore(source_->file, lineOf(asTable(node_)));
}

void TomlTable::refuseUnknownKeys() const {
    for (const auto& [key, value] : asTable(node_)) {
        if (std::find(section_->keys.begin(), section_->keys.end(), key.str()) != section_->keys.end()) continue;
        const std::vector<std::string> known(section_->keys.begin(), section_->keys.end());
        const int keyLine = std::max(1, static_cast<int>(key.source().begin.line));
        source_->diagnostics->error(ErrorCode::Parse, source_->file, keyLine,
                                    fmt::format("{}: unknown key {}; {}", label(), inQuotes(key.str()),
                                                suggestion(key.str(), known)));
    }
}

bool TomlTable::has(std::string_view key) const { return asTable(node_).contains(key); }

int TomlTable::line(std::string_view key) const {
    const auto* node = asTable(node_).get(key);
    return lineOf(node != nullptr ? *node : static_cast<const toml::node&>(asTable(node_)));
}

std::string TomlTable::where() const { return fmt::format("{}:{}", source_->file, lineOf(asTable(node_))); }
std::string TomlTable::where(std::string_view key) const { return fmt::format("{}:{}", source_->file, line(key)); }

/// "[[grid]] "Task area"": which of its kind, when it has a name.
std::string TomlTable::label() const {
    for (const auto* key : {"name", "id"})
        if (const auto name = asTable(node_)[key].value<std::string_view>())
            return fmt::format("{} {}", section_->title, inQuotes(*name));
    return std::string(section_->title);
}

void TomlTable::error(ErrorCode code, std::string_view key, const std::string& message) const {
    source_->diagnostics->error(code, source_->file, line(key), fmt::format("{}: {}", label(), message));
}

void TomlTable::warn(std::string_view key, const std::string& message) const {
    source_->diagnostics->warn(fmt::format("{}: {}: {}", where(key), label(), message));
}

void TomlTable::wrongType(std::string_view key, const std::string& expected) const {
    const auto& node = *asTable(node_).get(key);
    std::string seen(typeName(node));
    if (const auto* array = node.as_array()) seen = fmt::format("an array of {}", array->size());
    error(ErrorCode::Parse, key, fmt::format("{} is {}, expected {}", key, seen, expected));
}

void TomlTable::refuseChoice(std::string_view key, const std::string& seen, const std::vector<std::string>& names,
                             ErrorCode code) const {
    std::string expected;
    for (const auto& name : names) expected += fmt::format("{}\"{}\"", expected.empty() ? "" : ", ", name);
    const auto near = nearestNames(seen, names, 1);
    error(code, key, fmt::format("{} is {}, expected one of {}{}", key, inQuotes(seen), expected,
                                 near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near.front())));
}

bool TomlTable::refuseBoth(std::string_view key, std::string_view other) const {
    if (!has(key) || !has(other)) return false;
    error(ErrorCode::InvalidArgument, key, fmt::format("{} and {} exclude each other, expected one of them", key, other));
    return true;
}

bool TomlTable::require(std::string_view key) const {
    if (has(key)) return true;
    error(ErrorCode::Parse, "", fmt::format("{} is missing", key));
    return false;
}

std::string TomlTable::text(std::string_view key) const {
    if (!require(key)) return {};
    auto value = text(key, std::string());
    if (value.empty() && asTable(node_).get(key)->is_string())
        error(ErrorCode::InvalidArgument, key, fmt::format("{} is empty", key));
    return value;
}

std::string TomlTable::text(std::string_view key, const std::string& fallback) const {
    const auto* node = asTable(node_).get(key);
    if (node == nullptr) return fallback;
    if (const auto* value = node->as_string()) return value->get();
    if (auto date = dateText(*node)) return *date;
    wrongType(key, "a string");
    return fallback;
}

std::vector<std::string> TomlTable::texts(std::string_view key) const {
    std::vector<std::string> values;
    const auto* node = asTable(node_).get(key);
    if (node == nullptr) return values;
    const auto* array = node->as_array();
    const bool allText = array != nullptr && (array->empty() || array->is_homogeneous(toml::node_type::string));
    if (!allText) return wrongType(key, "an array of strings"), values;
    for (const auto& item : *array) values.push_back(*item.value<std::string>());
    return values;
}

bool TomlTable::flag(std::string_view key, bool fallback) const {
    const auto* node = asTable(node_).get(key);
    if (node == nullptr) return fallback;
    if (const auto* value = node->as_boolean()) return value->get();
    wrongType(key, "true or false");
    return fallback;
}

std::optional<double> TomlTable::numberIf(std::string_view key, const NumberRange& range) const {
    const auto* node = asTable(node_).get(key);
    if (node == nullptr) return std::nullopt;
    if (!node->is_number()) return wrongType(key, fmt::format("a number, {}", range.text())), std::nullopt;
    const double value = *node->value<double>();
    if (range.contains(value)) return value;
    error(ErrorCode::InvalidArgument, key, fmt::format("{} is {}, expected {}", key, value, range.text()));
    return std::nullopt;
}

double TomlTable::number(std::string_view key, const NumberRange& range) const {
    return require(key) ? numberIf(key, range).value_or(1.0) : 1.0;
}

double TomlTable::number(std::string_view key, const NumberRange& range, double fallback) const {
    return numberIf(key, range).value_or(fallback);
}

int TomlTable::integer(std::string_view key, int low, int high, int fallback) const {
    const auto* node = asTable(node_).get(key);
    if (node == nullptr) return fallback;
    if (!node->is_integer()) return wrongType(key, fmt::format("an integer, {} .. {}", low, high)), fallback;
    const auto value = *node->value<std::int64_t>();
    if (value >= low && value <= high) return static_cast<int>(value);
    error(ErrorCode::InvalidArgument, key, fmt::format("{} is {}, expected {} .. {}", key, value, low, high));
    return fallback;
}

void TomlTable::readIntegers(std::string_view key, int low, int high, std::span<int> values) const {
    const auto* array = asTable(node_).get(key)->as_array();
    const bool fits = array != nullptr && array->size() == values.size() &&
                      array->is_homogeneous(toml::node_type::integer);
    if (!fits) return wrongType(key, fmt::format("an array of {} integers", values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = *array->get(i)->value<std::int64_t>();
        if (value < low || value > high)
            return error(ErrorCode::InvalidArgument, key,
                         fmt::format("{}[{}] is {}, expected {} .. {}", key, i, value, low, high));
        values[i] = static_cast<int>(value);
    }
}

std::vector<double> TomlTable::numbers(std::string_view key, std::size_t count, const NumberRange& range) const {
    const std::vector<double> harmless(count, 1.0);
    if (!require(key)) return harmless;
    const auto values = numbersOf(*asTable(node_).get(key), count);
    if (!values) return wrongType(key, fmt::format("an array of {} numbers", count)), harmless;
    for (std::size_t i = 0; i < count; ++i) {
        if (range.contains((*values)[i])) continue;
        error(ErrorCode::InvalidArgument, key,
              fmt::format("{}[{}] is {}, expected {}", key, i, (*values)[i], range.text()));
        return harmless;
    }
    return *values;
}

Vec3d TomlTable::vector(std::string_view key) const {
    const auto v = numbers(key, 3, kCoordinate);
    return {v[0], v[1], v[2]};
}

Vec3d TomlTable::vector(std::string_view key, const Vec3d& fallback) const {
    return has(key) ? vector(key) : fallback;
}

Rgb TomlTable::colour(std::string_view key, const NumberRange& range) const {
    if (!require(key)) return {};
    if (asTable(node_).get(key)->is_number()) return Rgb(static_cast<float>(number(key, range)));
    if (!numbersOf(*asTable(node_).get(key), 3)) return wrongType(key, "a number or [r, g, b]"), Rgb{};
    const auto v = numbers(key, 3, range);
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

Rgb TomlTable::colour(std::string_view key, const NumberRange& range, const Rgb& fallback) const {
    return has(key) ? colour(key, range) : fallback;
}

std::vector<std::vector<double>> TomlTable::rows(std::string_view key, std::size_t width) const {
    std::vector<std::vector<double>> rows;
    if (!require(key)) return rows;
    const auto* array = asTable(node_).get(key)->as_array();
    if (array == nullptr) return wrongType(key, fmt::format("an array of arrays of {} numbers", width)), rows;
    const auto refuse = [&](const toml::node& row, ErrorCode code, const std::string& what) {
        source_->diagnostics->error(code, source_->file, lineOf(row), fmt::format("{}: {}", label(), what));
    };
    for (const auto& row : *array) {
        auto values = numbersOf(row, width);
        if (!values) {
            refuse(row, ErrorCode::Parse, fmt::format("{}[{}] is not an array of {} numbers", key, rows.size(), width));
            return rows;
        }
        for (const double value : *values) {
            if (kCoordinate.contains(value)) continue;
            refuse(row, ErrorCode::InvalidArgument,
                   fmt::format("{}[{}] has {}, expected {}", key, rows.size(), value, kCoordinate.text()));
            return rows;
        }
        rows.push_back(std::move(*values));
    }
    return rows;
}

std::vector<TomlTable> TomlTable::tables(std::string_view key, const TomlSection& section) const {
    std::vector<TomlTable> tables;
    const auto* node = asTable(node_).get(key);
    if (node == nullptr) return tables;
    const auto* array = node->as_array();
    if (array == nullptr) return wrongType(key, fmt::format("{} in double brackets", section.title)), tables;
    for (const auto& item : *array) {
        if (!item.is_table()) return wrongType(key, fmt::format("{} tables", section.title)), tables;
        tables.push_back(TomlTable(item.as_table(), section, *source_));
    }
    return tables;
}

std::optional<TomlTable> TomlTable::table(std::string_view key, const TomlSection& section) const {
    const auto* node = asTable(node_).get(key);
    if (node == nullptr) return std::nullopt;
    if (!node->is_table()) return wrongType(key, fmt::format("a table, {}", section.title)), std::nullopt;
    return TomlTable(node->as_table(), section, *source_);
}

Result<TomlDocument> TomlDocument::parse(std::string_view bytes, const std::string& name, Diagnostics& diagnostics) {
    auto parsed = tomlTree(bytes, name);
    if (!parsed) return parsed.error();
    TomlDocument document;
    document.source_ = std::make_shared<TomlSource>(TomlSource{name, &diagnostics});
    auto tree = std::make_shared<toml::table>(*std::move(parsed));
    document.tree_ = std::shared_ptr<const void>(tree, static_cast<const void*>(tree.get()));
    return document;
}

TomlTable TomlDocument::root(const TomlSection& section) const { return {tree_.get(), section, *source_}; }

}  // namespace luxdeck
