#pragma once

#include "engine/io/project_edit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/// What the edits in edits.h share.
namespace luxdeck::gui::edits {

/// An edit that collects changes of a text.
template <class Change>
std::function<Result<std::string>(const std::string&)> textEdit(Change change) {
    return [change = std::move(change)](const std::string& text) -> Result<std::string> {
        auto edit = ProjectEdit::of(text);
        if (!edit) return edit.error();
        if (auto done = change(*edit); !done) return done.error();
        return edit->text();
    };
}

/// To the micrometre: what is left of sums of binary fractions is nothing that anybody wrote.
inline double tidy(double value) { return std::round(value * 1e6) / 1e6; }
inline Vec3d tidy(const Vec3d& v) { return {tidy(v.x), tidy(v.y), tidy(v.z)}; }

/// The same key once: the last change counts.
inline void put(std::vector<KeyChange>& changes, const std::string& key, std::optional<TomlValue> value) {
    const auto at = std::find_if(changes.begin(), changes.end(), [&](const KeyChange& c) { return c.key == key; });
    if (at != changes.end()) at->value = std::move(value);
    else changes.push_back({key, std::move(value)});
}

inline void apply(ProjectEdit& edit, const TomlPlace& place, const std::vector<KeyChange>& changes) {
    for (const auto& change : changes)
        if (change.value) edit.set(place, change.key, *change.value);
        else edit.remove(place, change.key);
}

inline Vec3d vectorAt(const ProjectEdit& edit, const TomlPlace& place, const std::string& key, const Vec3d& fallback) {
    const auto v = edit.numbers(place, key);
    return v.size() == 3 ? Vec3d(v[0], v[1], v[2]) : fallback;
}

}  // namespace luxdeck::gui::edits
