#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace luxdeck::cal {

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
inline bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool isNamePart(char c) { return isLetter(c) || isDigit(c) || c == '_' || c == '.' || c == '`'; }

/// The characters of a function file without blanks and comments (in braces, which nest).
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) { skip(); }

    /// The next character that matters; 0 at the end.
    [[nodiscard]] char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    [[nodiscard]] bool atEnd() const { return at_ >= text_.size(); }
    [[nodiscard]] std::uint32_t line() const { return line_; }
    /// The line of a comment that is never closed; 0 when there is none.
    [[nodiscard]] std::uint32_t openComment() const { return openComment_; }

    void take() {
        ++at_;
        skip();
    }
    bool takeIf(char c) {
        if (atEnd() || next() != c) return false;
        take();
        return true;
    }
    std::string_view name() {
        const std::size_t from = at_;
        while (at_ < text_.size() && isNamePart(text_[at_])) ++at_;
        return taken(from);
    }
    /// Digits, a fraction and an exponent, as far as they go.
    std::string_view number() {
        const std::size_t from = at_;
        digits();
        if (at_ < text_.size() && text_[at_] == '.') ++at_, digits();
        if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
            ++at_;
            if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
            digits();
        }
        return taken(from);
    }

    /// What stands next, for messages.
    [[nodiscard]] std::string seen() const {
        if (atEnd()) return "the end";
        const char c = next();
        if (isNamePart(c)) {
            std::size_t end = at_;
            while (end < text_.size() && end - at_ < 40 && isNamePart(text_[end])) ++end;
            return "'" + std::string(text_.substr(at_, end - at_)) + "'";
        }
        if (c > ' ' && c < '\x7f') return std::string("'") + c + "'";
        return "byte " + std::to_string(static_cast<unsigned char>(c));
    }

private:
    void digits() {
        while (at_ < text_.size() && isDigit(text_[at_])) ++at_;
    }
    std::string_view taken(std::size_t from) {
        const auto result = text_.substr(from, at_ - from);
        skip();
        return result;
    }
    void skip() {
        std::size_t depth = 0;
        std::uint32_t opened = 0;
        for (; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '{' && depth++ == 0) opened = line_;
            else if (c == '}' && depth > 0) --depth;
            else if (depth == 0 && c != ' ' && c != '\t' && c != '\r' && c != '\n' && c != '\f' && c != '\v') break;
            if (c == '\n') ++line_;
        }
        if (depth > 0) openComment_ = opened;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::uint32_t line_ = 1;
    std::uint32_t openComment_ = 0;
};

}  // namespace luxdeck::cal
