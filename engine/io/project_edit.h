#pragma once

#include "engine/core/result.h"
#include "engine/io/toml_value.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck {

/// A table of a project file: the index-th [[section]] (from 0), or [section] itself with index 0; "" is the top level.
struct TomlPlace {
    std::string section;
    std::size_t index = 0;

    friend auto operator<=>(const TomlPlace&, const TomlPlace&) = default;
};

/// What a key becomes; none: it is removed, if it is there.
struct KeyChange {
    std::string key;
    std::optional<TomlValue> value;
};

/// Changes of a project file's text that leave everything else as it is written: comments, order, layout.
///
/// Changes are collected, all in terms of the text that was given (indices do not move), and done at once by text(). What comes out
/// is read again and compared with what was wanted: a layout that these edits cannot follow is an error, never another content.
///
///     auto edit = ProjectEdit::of(text);
///     edit->set({"luminaire", 3}, "dimming", 0.5);
///     edit->append("grid", {{"name", "Desk"}, {"origin", Vec3d(0, 0, 0.75)}});
///     Result<std::string> changed = edit->text();
class ProjectEdit {
public:
    /// errors  Parse ("line 12: ..."): not TOML
    static Result<ProjectEdit> of(std::string text);

    // ---- what is there ----
    /// How many tables a section has: of [[section]] as many as there are, of [section] one.
    [[nodiscard]] std::size_t count(std::string_view section) const;
    /// `path` is a key, or keys with dots: "array.count".
    [[nodiscard]] bool has(const TomlPlace& place, std::string_view path) const;
    [[nodiscard]] std::optional<std::string> string(const TomlPlace& place, std::string_view path) const;
    [[nodiscard]] std::optional<double> number(const TomlPlace& place, std::string_view path) const;
    /// Of an array of numbers; empty: there is none.
    [[nodiscard]] std::vector<double> numbers(const TomlPlace& place, std::string_view path) const;
    [[nodiscard]] std::vector<std::string> strings(const TomlPlace& place, std::string_view path) const;
    /// The first [[section]] whose `key` is this string.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view section, std::string_view key, std::string_view value) const;

    // ---- what becomes of it ----
    /// Sets a key where it stands, or adds it after the table's last one. A [section] that is not there is added.
    void set(const TomlPlace& place, const std::string& key, TomlValue value);
    /// Removes a key with its line; one that is not there is no error.
    void remove(const TomlPlace& place, const std::string& key);
    /// A new [[section]] after the last of its kind, or at the end of the text.
    void append(const std::string& section, std::vector<KeyChange> entries);
    /// The same as a copy of another, with changes.
    void appendCopy(const TomlPlace& of, std::vector<KeyChange> changes);
    /// Removes a [[section]] with the comments right above and right below it.
    void removeTable(const TomlPlace& place);
    /// Puts copies of a [[section]], each with its changes, in its place. The comments above it stay.
    void replaceTable(const TomlPlace& place, std::vector<std::vector<KeyChange>> copies);

    /// The text with all changes.
    ///
    /// errors  InvalidArgument: a table that is not there, one place changed twice, a value that TOML does not know;
    ///         Unsupported ("line 12: ..."): what is to be changed is written in a way that cannot be changed alone
    [[nodiscard]] Result<std::string> text() const;

private:
    struct Source;
    struct Added {
        std::string section;
        std::optional<TomlPlace> copyOf;
        std::vector<KeyChange> keys;
    };
    friend class ProjectEditing;

    std::shared_ptr<const Source> source_;
    std::map<TomlPlace, std::vector<KeyChange>> changed_;
    std::vector<Added> added_;
    std::map<TomlPlace, std::vector<std::vector<KeyChange>>> replaced_;  // by none: removed
};

}  // namespace luxdeck
