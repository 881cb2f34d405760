#pragma once

#include "engine/core/result.h"
#include "engine/io/rad_primitive.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace luxdeck::rad {

/// A `!` line: what follows the mark, lines joined that a backslash ends.
struct Command {
    std::string text;
    Place place;
};

/// The whole of a word as a number.
std::optional<double> numberOf(std::string_view word);

/// Reads the text of a scene description from left to right: primitives and commands, in their order.
class TextReader {
public:
    TextReader(std::string_view text, std::shared_ptr<const std::string> file) : text_(text), file_(std::move(file)) {}

    /// The next primitive or command, or nothing at the end.
    ///
    /// errors  Parse, Unsupported (a type that Radiance does not have): file:line, seen, expected
    Result<std::optional<std::variant<Primitive, Command>>> next();

private:
    [[nodiscard]] Place here() const { return {file_, line_}; }
    /// Past blanks and comments; false at the end of the text.
    bool skip();
    /// The next word, without its quotes; nothing at the end.
    std::optional<std::string> word();
    Result<std::string> expectWord(const std::string& what);
    /// How many arguments follow: a whole number that the rest of the text can hold.
    Result<std::size_t> count(const std::string& what);
    Result<std::vector<double>> numbers(const std::string& what);
    Result<void> arguments(Primitive& primitive);
    Command command();

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::shared_ptr<const std::string> file_;
};

}  // namespace luxdeck::rad
