#pragma once

#include "engine/core/result.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck::photometry {

/// A Parse error at a line of a file (1-based; 0: the file as a whole).
Error errorAt(const std::filesystem::path& file, std::size_t line, std::string message);

/// The text of a photometric file as UTF-8: byte-order marks removed, UTF-16 and ISO-8859-1 converted.
///
/// repairs   notes of what was converted are added
/// errors    Parse: empty, or binary (naming the offset of the first impossible byte)
Result<std::string> decodeText(std::string_view bytes, const std::filesystem::path& file,
                               std::vector<std::string>& repairs);

/// The lines of a text whatever ends them (CRLF, LF or CR); views into it.
std::vector<std::string_view> splitLines(std::string_view text);

std::string_view trim(std::string_view text);
std::string upperCase(std::string_view text);

/// A finite number that fills the whole token; nothing for anything else, "nan" and "inf" included.
/// Either '.' or ',' may be the decimal mark; with both, the last is, and the other groups thousands.
std::optional<double> parseNumber(std::string_view token);

/// `text` short enough for a message, in quotes, control characters replaced.
std::string inQuotes(std::string_view text);

struct Token {
    std::string_view text;
    std::size_t line = 0;  ///< 1-based
};

/// The numbers of a free-format file in order, over any mix of blanks, tabs, commas and line ends.
class TokenReader {
public:
    /// lines      of the whole file
    /// first      index of the line to start at
    /// repairs    a note is added when the commas turn out to be decimal marks
    TokenReader(std::filesystem::path file, const std::vector<std::string_view>& lines, std::size_t first,
                std::vector<std::string>& repairs);

    /// The next number, `what` naming it in errors. errors  Parse: the file ends, or it is no number
    Result<double> number(std::string_view what);
    /// The next number, which must be whole and within 1 .. most.
    Result<std::size_t> count(std::string_view what, std::size_t most);

    [[nodiscard]] std::size_t remaining() const { return tokens_.size() - next_; }
    [[nodiscard]] std::size_t line() const {
        return next_ > 0 ? tokens_[next_ - 1].line : firstLine_;
    }  ///< of the last number
    [[nodiscard]] std::string_view peek() const {
        return next_ < tokens_.size() ? tokens_[next_].text : std::string_view{};
    }
    [[nodiscard]] Error error(std::string message) const { return errorAt(file_, line(), std::move(message)); }

private:
    std::filesystem::path file_;
    std::vector<Token> tokens_;
    std::size_t next_ = 0;
    std::size_t firstLine_ = 0;
};

}  // namespace luxdeck::photometry
