#pragma once

#include "engine/core/result.h"
#include "engine/core/rgb.h"
#include "engine/core/vec.h"

#include <array>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace luxdeck {

/// The errors and warnings of one reading. Of the errors the one that stands first in the file is kept:
/// later ones are often its consequences, and the order of checking is no business of the user's.
class Diagnostics {
public:
    void error(ErrorCode code, const std::string& file, int line, std::string message);
    /// Whether an error is known in this file above this line.
    [[nodiscard]] bool hasErrorBefore(const std::string& file, int line) const {
        return first_.has_value() && file == file_ && line_ < line;
    }
    void warn(std::string text) { warnings_.push_back(std::move(text)); }

    [[nodiscard]] const std::optional<Error>& first() const { return first_; }
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

private:
    std::optional<Error> first_;
    std::string file_;
    int line_ = 0;
    std::vector<std::string> warnings_;
};

/// A kind of table and every key that it may have: declared once, for the reader and the documentation's test.
struct TomlSection {
    std::string_view title;                      ///< as it is written and as messages call it: "[[grid]]"
    std::span<const std::string_view> keys;
};

/// What a number may be. NaN and infinity never are.
struct NumberRange {
    double low = std::numeric_limits<double>::lowest();
    double high = std::numeric_limits<double>::max();
    bool lowExcluded = false;
    bool highExcluded = false;

    [[nodiscard]] bool contains(double value) const;
    [[nodiscard]] std::string text() const;  ///< "0 .. 1", "> 0", "0 .. < 1"
};

inline constexpr NumberRange kFraction{.low = 0, .high = 1};
/// Coordinates and lengths [m]: beyond 10^8 (two Earths) floats about any origin have lost their metres.
inline constexpr double kMaxCoordinateM = 1e8;
inline constexpr NumberRange kCoordinate{.low = -kMaxCoordinateM, .high = kMaxCoordinateM};
inline constexpr NumberRange kLength{.low = 0, .high = kMaxCoordinateM, .lowExcluded = true};

/// A name and what it stands for, for TomlTable::choice().
template <class E>
struct TomlChoice {
    std::string_view name;
    E value;
};

struct TomlSource;  // the file's name and its Diagnostics

/// A table of a TOML file with accessors that check. An accessor that finds something wrong (a wrong type, a
/// value out of range, a required key that is absent) tells Diagnostics and returns a harmless value, so that a
/// section reads as a list of its keys; the caller asks Diagnostics once, at the end. Overloads with a
/// `fallback` are for optional keys. Valid as long as the TomlDocument it came from.
class TomlTable {
public:
    [[nodiscard]] bool has(std::string_view key) const;
    [[nodiscard]] std::string where() const;                      ///< "file:line" of the table
    [[nodiscard]] std::string where(std::string_view key) const;  ///< of the key, or of the table without it
    void error(ErrorCode code, std::string_view key, const std::string& message) const;
    void warn(std::string_view key, const std::string& message) const;

    [[nodiscard]] std::string text(std::string_view key) const;   ///< not empty
    [[nodiscard]] std::string text(std::string_view key, const std::string& fallback) const;
    [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;  ///< absent: none
    [[nodiscard]] bool flag(std::string_view key, bool fallback) const;

    [[nodiscard]] double number(std::string_view key, const NumberRange& range) const;
    [[nodiscard]] double number(std::string_view key, const NumberRange& range, double fallback) const;
    [[nodiscard]] std::optional<double> numberIf(std::string_view key, const NumberRange& range) const;
    [[nodiscard]] int integer(std::string_view key, int low, int high, int fallback) const;

    [[nodiscard]] Vec3d vector(std::string_view key) const;       ///< three coordinates [m]
    [[nodiscard]] Vec3d vector(std::string_view key, const Vec3d& fallback) const;
    /// A number (grey) or [r, g, b].
    [[nodiscard]] Rgb colour(std::string_view key, const NumberRange& range) const;
    [[nodiscard]] Rgb colour(std::string_view key, const NumberRange& range, const Rgb& fallback) const;
    /// Arrays of `width` coordinates each; one error a key.
    [[nodiscard]] std::vector<std::vector<double>> rows(std::string_view key, std::size_t width) const;
    [[nodiscard]] std::vector<double> numbers(std::string_view key, std::size_t count, const NumberRange& range) const;

    /// #N integers, each in low .. high.
    template <std::size_t N>
    [[nodiscard]] std::array<int, N> integers(std::string_view key, int low, int high,
                                              const std::array<int, N>& fallback) const {
        if (!has(key)) return fallback;
        auto values = fallback;
        readIntegers(key, low, high, values);
        return values;
    }

    /// One of a few names; any other is an error that lists them, of the code given.
    template <class E>
    [[nodiscard]] E choice(std::string_view key, E fallback, std::span<const TomlChoice<E>> choices,
                           ErrorCode code = ErrorCode::InvalidArgument) const {
        if (!has(key)) return fallback;
        const auto seen = text(key);
        std::vector<std::string> names;
        for (const auto& c : choices) {
            if (c.name == seen) return c.value;
            names.emplace_back(c.name);
        }
        if (!seen.empty()) refuseChoice(key, seen, names, code);
        return fallback;
    }

    /// Calls read(table) for the tables of [[key]] in file order. It stops at the first error: no later table could
    /// have an earlier one, and a million bad tables are not worth a million messages.
    template <class Read>
    void each(std::string_view key, const TomlSection& section, const Read& read) const {
        for (const auto& table : tables(key, section)) {
            if (table.isPastFirstError()) return;
            read(table);
        }
    }

    /// The tables of [[key]], or none; the table of [key] or key = { }. Unknown keys in them are errors.
    [[nodiscard]] std::vector<TomlTable> tables(std::string_view key, const TomlSection& section) const;
    [[nodiscard]] std::optional<TomlTable> table(std::string_view key, const TomlSection& section) const;

    /// Says that of two keys that exclude each other both are there. Returns whether they are.
    bool refuseBoth(std::string_view key, std::string_view other) const;

private:
    friend class TomlDocument;
    TomlTable(const void* node, const TomlSection& section, const TomlSource& source);

    void refuseUnknownKeys() const;
    [[nodiscard]] bool isPastFirstError() const;
    void refuseChoice(std::string_view key, const std::string& seen, const std::vector<std::string>& names, ErrorCode code) const;
    void wrongType(std::string_view key, const std::string& expected) const;
    [[nodiscard]] bool require(std::string_view key) const;
    void readIntegers(std::string_view key, int low, int high, std::span<int> values) const;
    [[nodiscard]] int line(std::string_view key) const;
    [[nodiscard]] std::string label() const;

    const void* node_;  // toml::table, kept out of this header: toml++ takes seconds to compile
    const TomlSection* section_;
    const TomlSource* source_;
};

/// A parsed file. Diagnostics outlives it.
class TomlDocument {
public:
    /// name    what messages call the file
    /// errors  Parse: syntax, at file:line
    static Result<TomlDocument> parse(std::string_view bytes, const std::string& name, Diagnostics& diagnostics);

    /// The top level; `section` lists the keys and tables that it may have.
    [[nodiscard]] TomlTable root(const TomlSection& section) const;

private:
    std::shared_ptr<const void> tree_;
    std::shared_ptr<const TomlSource> source_;
};

/// The candidates that `seen` may have been meant to be, nearest first, at most `count`; none if all are far off.
std::vector<std::string> nearestNames(std::string_view seen, const std::vector<std::string>& candidates,
                                      std::size_t count = 3);

/// `did you mean "a" or "b"?`, or `known are "a", "b" ...`; for the end of a message.
std::string suggestion(std::string_view seen, const std::vector<std::string>& candidates);

/// A user's text for a message: quoted, and cut when it is longer than `mostBytes`.
std::string inQuotes(std::string_view text, std::size_t mostBytes = 60);

}  // namespace luxdeck
