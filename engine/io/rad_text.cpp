#include "engine/io/rad_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace luxdeck::rad {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }

/// As a message can show it.
std::string shown(std::string_view word) {
    std::string text(word.substr(0, 60));
    for (auto& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
    return text;
}

}  // namespace

std::optional<double> numberOf(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

bool TextReader::skip() {
    for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        if (c == '#') {
            at_ = std::min(text_.find('\n', at_), text_.size());
            if (at_ == text_.size()) return false;
            ++line_;
        } else if (c == '\n') {
            ++line_;
        } else if (!isBlank(c)) {
            return true;
        }
    }
    return false;
}

std::optional<std::string> TextReader::word() {
    if (!skip()) return std::nullopt;
    const char quote = text_[at_];
    if (quote == '"' || quote == '\'') {
        const auto end = text_.find(quote, at_ + 1);
        if (end != std::string_view::npos && text_.substr(at_, end - at_).find('\n') == std::string_view::npos) {
            std::string quoted(text_.substr(at_ + 1, end - at_ - 1));
            at_ = end + 1;
            return quoted;
        }
    }
    const auto start = at_;
    while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
    return std::string(text_.substr(start, at_ - start));
}

Result<std::string> TextReader::expectWord(const std::string& what) {
    auto found = word();
    if (found) return *std::move(found);
    return here().error(ErrorCode::Parse, fmt::format("the file ends, expected {}", what));
}

Result<std::size_t> TextReader::count(const std::string& what) {
    const auto found = expectWord(fmt::format("the number of {}", what));
    if (!found) return found.error();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(found->data(), found->data() + found->size(), value);
    if (error != std::errc() || end != found->data() + found->size())
        return here().error(ErrorCode::Parse, fmt::format("'{}', expected the number of {}", shown(*found), what));
    if (value > (text_.size() - at_ + 1) / 2)  // each takes a character and a blank
        return here().error(ErrorCode::Parse, fmt::format("{} {} are announced, the file ends before", value, what));
    return value;
}

Result<std::vector<double>> TextReader::numbers(const std::string& what) {
    const auto size = count(what);
    if (!size) return size.error();
    std::vector<double> values;
    values.reserve(*size);
    while (values.size() < *size) {
        const auto found = expectWord(fmt::format("{} of {} {}", values.size() + 1, *size, what));
        if (!found) return found.error();
        const auto value = numberOf(*found);
        if (!value)
            return here().error(ErrorCode::Parse, fmt::format("'{}', expected a finite number ({} of {} {})", shown(*found),
                                                              values.size() + 1, *size, what));
        values.push_back(*value);
    }
    return values;
}

Result<void> TextReader::arguments(Primitive& primitive) {
    const auto subject = fmt::format("arguments of {} {}", primitive.type, shown(primitive.name));
    const auto size = count("string " + subject);
    if (!size) return size.error();
    primitive.strings.reserve(*size);
    while (primitive.strings.size() < *size) {
        auto found = expectWord(fmt::format("{} of {} string {}", primitive.strings.size() + 1, *size, subject));
        if (!found) return found.error();
        primitive.strings.push_back(*std::move(found));
    }
    const auto integers = numbers("integer " + subject);
    if (!integers) return integers.error();
    if (!integers->empty())
        return here().error(ErrorCode::Parse, fmt::format("{} integer {}, expected 0: no primitive has any", integers->size(), subject));
    auto reals = numbers("real " + subject);
    if (!reals) return reals.error();
    primitive.numbers = *std::move(reals);
    return {};
}

Command TextReader::command() {
    Command command{{}, here()};
    ++at_;  // the mark
    while (at_ < text_.size()) {
        const auto end = std::min(text_.find('\n', at_), text_.size());
        auto line = text_.substr(at_, end - at_);
        at_ = std::min(end + 1, text_.size());
        if (end < text_.size()) ++line_;
        if (line.ends_with('\r')) line.remove_suffix(1);
        const bool continues = line.ends_with('\\');
        if (continues) line.remove_suffix(1);
        command.text += line;
        if (!continues) break;
        command.text += ' ';
    }
    return command;
}

Result<std::optional<std::variant<Primitive, Command>>> TextReader::next() {
    using Item = std::optional<std::variant<Primitive, Command>>;
    if (!skip()) return Item{};
    if (text_[at_] == '!') return Item{command()};
    Primitive primitive;
    primitive.place = here();
    primitive.modifier = *word();
    auto type = expectWord(fmt::format("the type of a primitive after its modifier '{}'", shown(primitive.modifier)));
    if (!type) return type.error();
    primitive.type = *std::move(type);
    if (!isKnownType(primitive.type))
        return here().error(ErrorCode::Unsupported, fmt::format("'{} {}', expected a modifier and one of Radiance's types", shown(primitive.modifier), shown(primitive.type)));
    auto name = expectWord(fmt::format("the name of the {}", primitive.type));
    if (!name) return name.error();
    primitive.name = *std::move(name);
    if (primitive.type == "alias") {
        auto reference = expectWord(fmt::format("what alias {} stands for", shown(primitive.name)));
        if (!reference) return reference.error();
        primitive.strings.push_back(*std::move(reference));
    } else if (auto read = arguments(primitive); !read) {
        return read.error();
    }
    return Item{std::move(primitive)};
}

}  // namespace luxdeck::rad
