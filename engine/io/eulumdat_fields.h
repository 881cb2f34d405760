#pragma once

#include "engine/io/photometry_text.h"
#include "engine/scene/candela_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck::photometry {

/// The lines of an EULUMDAT file, one field each, in order. Blank lines are fields.
class FieldReader {
public:
    FieldReader(const std::filesystem::path& file, std::vector<std::string_view> lines, Photometry& photometry)
        : file_(file), lines_(std::move(lines)), photometry_(photometry) {
        while (!lines_.empty() && trim(lines_.back()).empty()) lines_.pop_back();
    }

    Result<std::string> text(const char* what) {
        if (next_ >= lines_.size()) return error(fmt::format("the file ends here, expected {}", what));
        return std::string(trim(lines_[next_++]));
    }

    /// A number that must be there.
    Result<double> number(const char* what) {
        const auto field = text(what);
        if (!field) return field.error();
        const auto value = parseField(*field);
        if (!value) return error(fmt::format("seen {}, expected {} (a finite number)", inQuotes(*field), what));
        return *value;
    }

    /// A number that tools leave blank or fill with text: then `otherwise`, with a repair.
    Result<double> lenientNumber(const char* what, double otherwise) {
        const auto field = text(what);
        if (!field) return field.error();
        if (const auto value = parseField(*field)) return *value;
        photometry_.repairs.push_back(
            fmt::format("line {}: {} is {}, taken as {:.4g}", next_, what, inQuotes(*field), otherwise));
        return otherwise;
    }

    Result<std::size_t> count(const char* what, std::size_t least, std::size_t most) {
        const auto value = number(what);
        if (!value) return value.error();
        if (!(*value >= static_cast<double>(least) && *value <= static_cast<double>(most)) ||
            *value != std::floor(*value)) {
            return error(fmt::format("{} is {}, expected a whole number from {} to {}", what, *value, least, most));
        }
        return static_cast<std::size_t>(*value);
    }

    Result<void> skip(std::size_t fields, const char* what) {
        for (std::size_t i = 0; i < fields; ++i) {
            if (auto field = text(what); !field) return field.error();
        }
        return {};
    }

    [[nodiscard]] std::size_t remaining() const { return lines_.size() - next_; }
    [[nodiscard]] std::size_t line() const { return next_; }  ///< of the last field, 1-based
    [[nodiscard]] Error error(std::string message) const { return errorAt(file_, next_, std::move(message)); }

private:
    /// Blanks and apostrophes group thousands in some tools ("10 080", "10'080").
    static std::optional<double> parseField(std::string field) {
        std::erase_if(field, [](char c) { return c == ' ' || c == '\''; });
        return parseNumber(field);
    }

    const std::filesystem::path& file_;
    std::vector<std::string_view> lines_;
    Photometry& photometry_;
    std::size_t next_ = 0;
};

}  // namespace luxdeck::photometry
