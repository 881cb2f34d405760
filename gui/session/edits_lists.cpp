#include "gui/session/edit_text.h"
#include "gui/session/edits.h"

#include <set>

namespace luxdeck::gui::edits {

namespace {

std::vector<KeyChange> keysOf(const GridChange& grid) {
    std::vector<KeyChange> keys;
    if (grid.name) put(keys, "name", TomlValue(*grid.name));
    if (grid.origin) put(keys, "origin", TomlValue(tidy(*grid.origin)));
    if (grid.u) put(keys, "u", TomlValue(tidy(*grid.u)));
    if (grid.v) put(keys, "v", TomlValue(tidy(*grid.v)));
    if (grid.borderM) put(keys, "border", TomlValue(tidy(*grid.borderM)));
    // Spacing and counts exclude each other: the one that is said takes the other's place.
    if (grid.spacingM) put(keys, "spacing", TomlValue(tidy(*grid.spacingM))), put(keys, "counts", std::nullopt);
    if (grid.counts) put(keys, "counts", TomlValue(std::vector<int>(grid.counts->begin(), grid.counts->end()))), put(keys, "spacing", std::nullopt);
    if (!grid.requirement) return keys;
    put(keys, "requirements", std::nullopt);
    put(keys, "requirement", grid.requirement->empty() ? std::optional<TomlValue>() : TomlValue(*grid.requirement));
    return keys;
}

std::vector<KeyChange> keysOf(const View& view) {
    const bool fisheye = view.kind == ViewKind::Fisheye;
    std::vector<KeyChange> keys{{"name", TomlValue(view.name)},
                                {"kind", TomlValue(fisheye ? "fisheye" : "perspective")},
                                {"position", TomlValue(tidy(view.position))},
                                {"direction", TomlValue(tidy(view.direction))}};
    if (view.up != Vec3d(0, 0, 1)) put(keys, "up", TomlValue(tidy(view.up)));
    if (!fisheye) put(keys, "vertical_fov_deg", TomlValue(tidy(view.verticalFovDeg)));
    put(keys, "size", TomlValue(std::vector<int>{view.width, view.height}));
    return keys;
}

}  // namespace

Edit addGrid(GridChange grid) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        edit.append("grid", keysOf(grid));
        return {};
    });
}

Edit changeGrid(std::size_t grid, GridChange change) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        apply(edit, {"grid", grid}, keysOf(change));
        return {};
    });
}

Edit removeGrid(std::size_t grid) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        edit.removeTable({"grid", grid});
        return {};
    });
}

std::vector<std::string> requirementIds(const std::string& text) {
    std::vector<std::string> ids;
    const auto edit = ProjectEdit::of(text);
    if (!edit) return ids;
    std::set<std::string> known;
    const auto add = [&](const std::optional<std::string>& id) {
        if (id && known.insert(*id).second) ids.push_back(*id);
    };
    for (std::size_t i = 0; i < edit->count("requirement"); ++i) add(edit->string({"requirement", i}, "id"));
    for (std::size_t i = 0; i < edit->count("grid"); ++i) add(edit->string({"grid", i}, "requirement"));
    return ids;
}

std::string requirementId(const std::string& text, std::size_t grid) {
    const auto edit = ProjectEdit::of(text);
    return edit ? edit->string({"grid", grid}, "requirement").value_or("") : "";
}

Edit addView(Shown project, View view) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        if (edit.count("view") == 0)
            for (const auto& camera : project->project.views) edit.append("view", keysOf(camera));
        edit.append("view", keysOf(view));
        return {};
    });
}

Edit changeView(std::size_t index, View view) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        auto keys = keysOf(view);
        put(keys, "target", std::nullopt);  // a direction and a target exclude each other
        if (view.up == Vec3d(0, 0, 1)) put(keys, "up", std::nullopt);
        if (view.kind == ViewKind::Fisheye) put(keys, "vertical_fov_deg", std::nullopt);
        apply(edit, {"view", index}, keys);
        return {};
    });
}

Edit renameView(std::size_t index, std::string name) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        edit.set({"view", index}, "name", name);
        return {};
    });
}

Edit removeView(std::size_t index) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        edit.removeTable({"view", index});
        return {};
    });
}

Edit setInfo(std::string key, std::string value) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        if (value.empty()) edit.remove({"project", 0}, key);
        else edit.set({"project", 0}, key, value);
        return {};
    });
}

}  // namespace luxdeck::gui::edits
