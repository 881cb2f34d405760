#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace luxdeck::obj {

inline bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// The words of one line, from left to right.
class Words {
public:
    explicit Words(std::string_view line) : rest_(line) {}

    /// The next word; empty at the end of the line.
    std::string_view next() {
        skipBlanks();
        std::size_t end = 0;
        while (end < rest_.size() && !isBlank(rest_[end])) ++end;
        const auto word = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return word;
    }
    /// All that is left, without blanks around it: names may hold spaces.
    std::string_view remainder() {
        skipBlanks();
        while (!rest_.empty() && isBlank(rest_.back())) rest_.remove_suffix(1);
        return rest_;
    }
    /// The next word as a number; none when it is not wholly one (the word is taken all the same).
    std::optional<double> number() {
        std::string_view word = next();
        if (word.starts_with('+')) word.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
        return value;
    }
    [[nodiscard]] bool atEnd() {
        skipBlanks();
        return rest_.empty();
    }

private:
    void skipBlanks() {
        while (!rest_.empty() && isBlank(rest_.front())) rest_.remove_prefix(1);
    }
    std::string_view rest_;
};

/// The lines of an OBJ or MTL file without comments; a backslash at the end joins the next line.
class Lines {
public:
    explicit Lines(std::string_view text) : rest_(text) {
        if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    }

    /// Moves to the next line; false at the end of the text.
    bool next() {
        if (rest_.empty()) return false;
        number_ += taken_;
        taken_ = 0;
        line_ = take();
        if (!line_.ends_with('\\')) return true;
        joined_.clear();
        while (line_.ends_with('\\')) {
            joined_.append(line_.substr(0, line_.size() - 1)).push_back(' ');
            if (rest_.empty()) break;
            line_ = take();
        }
        if (!line_.ends_with('\\')) joined_.append(line_);
        line_ = joined_;
        return true;
    }
    /// Valid until the next call of next().
    [[nodiscard]] std::string_view line() const { return line_; }
    [[nodiscard]] std::size_t number() const { return number_; }  ///< of the line, from 1

private:
    std::string_view take() {
        ++taken_;
        const auto end = rest_.find('\n');
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        if (const auto comment = line.find('#'); comment != std::string_view::npos) line = line.substr(0, comment);
        while (!line.empty() && isBlank(line.back())) line.remove_suffix(1);
        return line;
    }

    std::string_view rest_;
    std::string_view line_;
    std::string joined_;
    std::size_t number_ = 1;
    std::size_t taken_ = 0;
};

}  // namespace luxdeck::obj
