#include "engine/io/photometry_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace luxdeck::photometry {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v' || c == '\r' || c == '\n'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

void appendUtf8(std::string& out, std::uint32_t code) {
    if (code < 0x80) {
        out += static_cast<char>(code);
    } else if (code < 0x800) {
        out += static_cast<char>(0xC0 | (code >> 6));
        out += static_cast<char>(0x80 | (code & 0x3F));
    } else {
        out += static_cast<char>(0xE0 | (code >> 12));
        out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
        out += static_cast<char>(0x80 | (code & 0x3F));
    }
}

std::string fromUtf16(std::string_view bytes, bool bigEndian) {
    std::string out;
    out.reserve(bytes.size() / 2);
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        const auto first = static_cast<unsigned char>(bytes[i]);
        const auto second = static_cast<unsigned char>(bytes[i + 1]);
        const std::uint32_t code = bigEndian ? first * 256U + second : second * 256U + first;
        const bool surrogate = code >= 0xD800 && code < 0xE000;
        appendUtf8(out, surrogate ? U'?' : code);
    }
    return out;
}

bool isUtf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i++]);
        int following = 0;
        if (lead >= 0xC2 && lead < 0xE0) following = 1;
        else if (lead >= 0xE0 && lead < 0xF0) following = 2;
        else if (lead >= 0xF0 && lead < 0xF5) following = 3;
        else if (lead >= 0x80) return false;
        for (; following > 0; --following, ++i) {
            if (i >= text.size() || (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) return false;
        }
    }
    return true;
}

/// Control characters that no text has; ^Z ended files under DOS.
bool isBinary(char c) {
    const auto u = static_cast<unsigned char>(c);
    return u < 0x20 && !isBlank(c) && c != '\x1A';
}

/// "0,5" as a word of its own: one comma, between digits (or leading them).
bool looksLikeDecimalComma(std::string_view word) {
    const auto comma = word.find(',');
    return comma != std::string_view::npos && word.find(',', comma + 1) == std::string_view::npos &&
           comma + 1 < word.size() && isDigit(word[comma + 1]);
}

/// Whether the commas of free-format numbers are decimal marks rather than separators: then no number has a
/// point, and each comma sits alone inside a word.
bool commasAreDecimal(const std::vector<std::string_view>& lines, std::size_t first) {
    bool any = false;
    for (std::size_t i = first; i < lines.size(); ++i) {
        std::string_view rest = lines[i];
        if (rest.find('.') != std::string_view::npos) return false;
        while (!(rest = trim(rest)).empty()) {
            const auto end = static_cast<std::size_t>(std::find_if(rest.begin(), rest.end(), isBlank) - rest.begin());
            const auto word = rest.substr(0, end);
            rest.remove_prefix(end);
            if (word.find(',') == std::string_view::npos) continue;
            if (!looksLikeDecimalComma(word)) return false;
            any = true;
        }
    }
    return any;
}

}  // namespace

Error errorAt(const std::filesystem::path& file, std::size_t line, std::string message) {
    return Error{ErrorCode::Parse, std::move(message),
                 line > 0 ? fmt::format("{}:{}", file.string(), line) : file.string()};
}

Result<std::string> decodeText(std::string_view bytes, const std::filesystem::path& file,
                               std::vector<std::string>& repairs) {
    std::string text;
    if (bytes.substr(0, 2) == "\xFF\xFE" || bytes.substr(0, 2) == "\xFE\xFF") {
        text = fromUtf16(bytes.substr(2), bytes[0] == '\xFE');
        repairs.emplace_back("converted from UTF-16");
    } else if (bytes.substr(0, 3) == "\xEF\xBB\xBF") {
        text = bytes.substr(3);
        repairs.emplace_back("removed a byte-order mark");
    } else {
        text = bytes;
    }
    if (trim(text).empty()) return errorAt(file, 0, "the file is empty, expected photometric data");

    const auto binary = std::find_if(text.begin(), text.end(), isBinary);
    if (binary != text.end()) {
        const auto line = static_cast<std::size_t>(std::count(text.begin(), binary, '\n')) + 1;
        return errorAt(file, line,
                       fmt::format("seen the byte 0x{:02x} at offset {}, expected text",
                                   static_cast<unsigned char>(*binary), binary - text.begin()));
    }
    if (isUtf8(text)) return text;
    std::string converted;
    for (const char c : text) appendUtf8(converted, static_cast<unsigned char>(c));
    return converted;
}

std::vector<std::string_view> splitLines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const auto end = std::min(text.find_first_of("\r\n"), text.size());
        lines.push_back(text.substr(0, end));
        const bool pair = text.substr(end, 2) == "\r\n";
        text.remove_prefix(std::min(end + (pair ? 2 : 1), text.size()));
    }
    return lines;
}

std::string_view trim(std::string_view text) {
    const auto blank = [](char c) { return isBlank(c) || c == '\x1A'; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string upperCase(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
    return out;
}

std::optional<double> parseNumber(std::string_view token) {
    if (!token.empty() && token.front() == '+') token.remove_prefix(1);
    constexpr std::size_t kLongest = 64;
    if (token.empty() || token.size() > kLongest) return std::nullopt;
    const auto mark = token.find_last_of(".,");
    char plain[kLongest];
    std::size_t size = 0;
    for (std::size_t i = 0; i < token.size(); ++i) {
        const bool separator = token[i] == '.' || token[i] == ',';
        if (separator && i != mark) {
            if (token[i] == token[mark]) return std::nullopt;  // "1.2.3" is no number
            continue;
        }
        plain[size++] = separator ? '.' : token[i];
    }
    double value = 0;
    const auto [end, failure] = std::from_chars(plain, plain + size, value);
    if (failure != std::errc{} || end != plain + size || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string inQuotes(std::string_view text) {
    constexpr std::size_t kLongest = 40;
    std::string out = "\"";
    out += text.substr(0, kLongest);
    std::replace_if(
        out.begin(), out.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
    return out + (text.size() > kLongest ? "...\"" : "\"");
}

TokenReader::TokenReader(std::filesystem::path file, const std::vector<std::string_view>& lines, std::size_t first,
                         std::vector<std::string>& repairs)
    : file_(std::move(file)), firstLine_(first) {
    const bool decimalCommas = commasAreDecimal(lines, first);
    if (decimalCommas) repairs.emplace_back("read commas as decimal marks");
    const auto separates = [&](char c) { return isBlank(c) || c == '\x1A' || (c == ',' && !decimalCommas); };
    for (std::size_t i = first; i < lines.size(); ++i) {
        const std::string_view line = lines[i];
        std::size_t at = 0;
        while (at < line.size()) {
            while (at < line.size() && separates(line[at])) ++at;
            const std::size_t start = at;
            while (at < line.size() && !separates(line[at])) ++at;
            if (at > start) tokens_.push_back({line.substr(start, at - start), i + 1});
        }
    }
}

Result<double> TokenReader::number(std::string_view what) {
    if (next_ >= tokens_.size()) return error(fmt::format("the file ends here, expected {}", what));
    const Token& token = tokens_[next_++];
    const auto value = parseNumber(token.text);
    if (!value) return error(fmt::format("seen {}, expected {} (a finite number)", inQuotes(token.text), what));
    return *value;
}

Result<std::size_t> TokenReader::count(std::string_view what, std::size_t most) {
    const auto value = number(what);
    if (!value) return value.error();
    if (!(*value >= 1 && *value <= static_cast<double>(most)) || *value != std::floor(*value)) {
        return error(fmt::format("{} is {}, expected a whole number from 1 to {}", what, *value, most));
    }
    return static_cast<std::size_t>(*value);
}

}  // namespace luxdeck::photometry
