#pragma once

#include "engine/core/result.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace luxdeck::cal {

/// Expressions nest at most this deep (parentheses, calls, and the terms of a sum), so that walking one by
/// recursion is safe.
inline constexpr std::size_t kMostNesting = 1000;

enum class SyntaxKind : std::uint8_t {
    Number,
    Name,
    Parameter,
    Call,
    CallParameter,
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power
};

/// One part of an expression as it was written.
struct SyntaxNode {
    SyntaxKind kind = SyntaxKind::Number;
    std::uint16_t depth = 1;         ///< levels below and with this one
    std::uint32_t line = 0;          ///< from 1
    std::uint32_t parameter = 0;     ///< Parameter, CallParameter: which one
    double number = 0;
    std::string name;                ///< Name, Call
    std::vector<std::uint32_t> kids; ///< operands or arguments, indices of nodes
};

/// "name = e", "name : e" (a constant), "f(x,y) = e", "f(x,y) : e".
struct Definition {
    std::string name;
    std::vector<std::string> parameters;  ///< none: a variable
    std::uint32_t root = 0;               ///< node
    std::uint32_t line = 0;

    [[nodiscard]] bool isFunction() const { return !parameters.empty(); }
};

/// The definitions of one text in Radiance's function language. Constant once it is made.
///
/// Names may hold letters, digits, "_", "." and "`", which separates a name from its context: every file is a
/// context of its own here, so "name`" is this file's, "`name" is one that every file sees.
/// source   Radiance's calcomp: "-" binds closer than "^", which goes from right to left
class Module {
public:
    /// name        of the file, for messages
    /// errors      Parse, "name:line": what was seen, what was expected
    static Result<std::shared_ptr<const Module>> parse(std::string_view text, const std::string& name);
    /// Definitions that stand in another file, at `where`.
    static Result<std::shared_ptr<const Module>> parseAt(std::string_view text, const std::string& where);
    /// One expression, as the definition of `name` with these parameters.
    static Result<std::shared_ptr<const Module>> expression(const std::string& name,
                                                            const std::vector<std::string>& parameters,
                                                            std::string_view text, const std::string& where);
    /// A call of the function `function` with `count` parameters of its own, as the definition of "".
    static std::shared_ptr<const Module> call(const std::string& function, std::size_t count, const std::string& where);

    [[nodiscard]] const Definition* find(std::string_view name) const;
    [[nodiscard]] const SyntaxNode& node(std::uint32_t index) const { return nodes_[index]; }
    [[nodiscard]] const std::string& hash() const { return hash_; }  ///< of the text
    /// Where a line is: "name:line".
    [[nodiscard]] std::string where(std::uint32_t line) const;

private:
    friend class Parser;
    std::string name_;
    bool ownLines_ = true;  ///< lines are this text's, not those of a file about it
    std::string hash_;
    std::vector<SyntaxNode> nodes_;
    std::unordered_map<std::string, Definition> definitions_;
};

}  // namespace luxdeck::cal
