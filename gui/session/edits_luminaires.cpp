#include "gui/session/edit_text.h"
#include "gui/session/edits.h"

#include "engine/io/project_aim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace luxdeck::gui::edits {

namespace {

constexpr const char* kSection = "luminaire";
constexpr const char* kAimAngles[] = {"orient", "tilt", "roll", "spin"};

/// One luminaire in the text: a [[luminaire]], or a place in its rows.
struct Place {
    std::size_t table = 0;
    std::size_t member = 0;  // in the order in which rows are numbered
    std::size_t members = 1;
    Vec3d position{0, 0, 0};
};

std::array<std::size_t, 2> countOf(const ProjectEdit& edit, std::size_t table) {
    const auto count = edit.numbers({kSection, table}, "array.count");
    if (count.size() != 2 || !(count[0] >= 1) || !(count[1] >= 1)) return {1, 1};
    return {static_cast<std::size_t>(count[0]), static_cast<std::size_t>(count[1])};
}

/// Every luminaire of the text, in the order in which the reader places them.
std::vector<Place> placesIn(const ProjectEdit& edit) {
    std::vector<Place> places;
    for (std::size_t table = 0; table < edit.count(kSection); ++table) {
        const auto [columns, rows] = countOf(edit, table);
        const auto spacing = edit.numbers({kSection, table}, "array.spacing");
        const auto first = vectorAt(edit, {kSection, table}, "position", Vec3d(0, 0, 0));
        for (std::size_t i = 0; i < columns * rows; ++i) {
            Vec3d offset(0, 0, 0);
            if (spacing.size() == 2) offset = Vec3d(spacing[0] * static_cast<double>(i % columns), spacing[1] * static_cast<double>(i / columns), 0);
            places.push_back({table, i, columns * rows, first + offset});
        }
    }
    return places;
}

/// The places of the luminaires that are shown. Those of the geometry come first in the scene and are not in the text.
struct Shift {
    std::vector<Place> places;
    std::size_t first = 0;  // in the scene

    [[nodiscard]] const Place& of(std::size_t luminaire) const { return places[luminaire - first]; }
};

Result<Shift> matched(const Project& project, const ProjectEdit& edit, const std::vector<std::size_t>& luminaires) {
    const auto& scene = project.scene;
    Shift shift{placesIn(edit), 0};
    // Types of the text come last, too: a light of the geometry has one of its own.
    const auto types = edit.count("luminaire_type");
    const auto firstType = scene.luminaireTypes.size() - std::min(types, scene.luminaireTypes.size());
    for (const auto& luminaire : scene.luminaires) shift.first += luminaire.type < firstType ? 1 : 0;
    if (shift.first + shift.places.size() != scene.luminaires.size())
        return Error{ErrorCode::InvalidArgument, "the luminaires have just changed, expected to edit them as they are shown: try again", {}};
    for (const auto i : luminaires) {
        if (i >= scene.luminaires.size()) return Error{ErrorCode::InvalidArgument, fmt::format("there is no luminaire {}, expected one of {}", i + 1, scene.luminaires.size()), {}};
        if (i < shift.first)
            return Error{ErrorCode::InvalidArgument, fmt::format("\"{}\" is a light of a geometry file, expected a luminaire of the project: it is changed where the model was made", scene.luminaires[i].name), {}};
    }
    return shift;
}

std::vector<KeyChange> keysOf(const LuminaireChange& change, const Vec3d& position) {
    std::vector<KeyChange> keys;
    if (change.position) put(keys, "position", TomlValue(tidy(*change.position)));
    if (change.moveBy) put(keys, "position", TomlValue(tidy(change.position.value_or(position) + *change.moveBy)));
    if (change.aim) put(keys, "aim", TomlValue(tidy(*change.aim)));
    if (change.rotationDeg) put(keys, "rotation_deg", TomlValue(tidy(*change.rotationDeg)));
    if (change.aim || change.rotationDeg)  // what a luminaire had by LM-72's angles is now said in this way
        for (const char* key : kAimAngles) keys.push_back({key, std::nullopt});
    if (change.dimming) put(keys, "dimming", TomlValue(tidy(*change.dimming)));
    if (change.name) put(keys, "name", TomlValue(*change.name));
    if (change.type) put(keys, "type", TomlValue(*change.type));
    return keys;
}

/// Whether rows as a whole can be told the change.
bool fitsRows(const LuminaireChange& change) { return !change.position && !change.name; }

/// A member of rows as a luminaire of its own. Without a name it is numbered by its type as it was in its row.
std::vector<KeyChange> alone(const Place& place, bool named, const std::string& name) {
    std::vector<KeyChange> keys{{"array", std::nullopt}, {"position", TomlValue(tidy(place.position))}};
    if (named) put(keys, "name", TomlValue(name));
    return keys;
}

/// Luminaires by the table that they are written in.
std::map<std::size_t, std::set<std::size_t>> byTable(const Shift& shift, const std::vector<std::size_t>& luminaires) {
    std::map<std::size_t, std::set<std::size_t>> tables;
    for (const auto i : luminaires) tables[shift.of(i).table].insert(i);
    return tables;
}

/// Writes rows one by one; `change` says what becomes of each, or that it goes.
template <class ChangeOf>
void split(ProjectEdit& edit, const Project& project, const Shift& shift, std::size_t table, const ChangeOf& change) {
    std::vector<std::vector<KeyChange>> copies;
    const bool named = edit.has({kSection, table}, "name");
    for (std::size_t i = 0; i < shift.places.size(); ++i) {
        if (shift.places[i].table != table) continue;
        const auto index = shift.first + i;
        auto keys = alone(shift.places[i], named, project.scene.luminaires[index].name);
        if (change(index, keys)) copies.push_back(std::move(keys));
    }
    edit.replaceTable({kSection, table}, std::move(copies));
}

}  // namespace

Result<LuminairePlaced> placedLuminaire(const Project& project, const std::string& text, std::size_t luminaire) {
    const auto edit = ProjectEdit::of(text);
    if (!edit) return edit.error();
    const auto shift = matched(project, *edit, {luminaire});
    if (!shift) return shift.error();
    const auto& place = shift->of(luminaire);
    const TomlPlace table{kSection, place.table};
    LuminairePlaced out;
    out.position = place.position;
    out.aim = vectorAt(*edit, table, "aim", out.aim);
    out.rotationDeg = edit->number(table, "rotation_deg").value_or(0);
    if (std::any_of(std::begin(kAimAngles), std::end(kAimAngles), [&](const char* key) { return edit->has(table, key); })) {
        const auto& frame = project.scene.luminaires[luminaire].frame;
        out.aim = -Vec3d(frame.normal);
        const auto unturned = luminaireFrame(out.aim, 0);
        out.rotationDeg = std::atan2(dot(frame.tangent, unturned.bitangent), dot(frame.tangent, unturned.tangent)) / kDegree;
    }
    out.dimming = edit->number(table, "dimming").value_or(1);
    out.name = project.scene.luminaires[luminaire].name;
    out.type = edit->string(table, "type").value_or("");
    out.inArray = place.members > 1;
    return out;
}

Edit changeLuminaires(Shown project, std::vector<std::size_t> luminaires, LuminaireChange change) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        const auto shift = matched(project->project, edit, luminaires);
        if (!shift) return shift.error();
        for (const auto& [table, chosen] : byTable(*shift, luminaires)) {
            const auto& first = shift->of(*chosen.begin());
            if (first.members == 1 || (first.members == chosen.size() && fitsRows(change))) {
                apply(edit, {kSection, table}, keysOf(change, first.position));
                continue;
            }
            split(edit, project->project, *shift, table, [&](std::size_t index, std::vector<KeyChange>& keys) {
                if (chosen.contains(index))
                    for (auto& key : keysOf(change, shift->of(index).position)) put(keys, key.key, std::move(key.value));
                return true;
            });
        }
        return {};
    });
}

Edit switchLuminaires(Shown project, std::vector<std::size_t> luminaires, bool on) {
    LuminaireChange change;
    change.dimming = on ? 1.0 : 0.0;
    return changeLuminaires(std::move(project), std::move(luminaires), std::move(change));
}

Edit removeLuminaires(Shown project, std::vector<std::size_t> luminaires) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        const auto shift = matched(project->project, edit, luminaires);
        if (!shift) return shift.error();
        for (const auto& [table, chosen] : byTable(*shift, luminaires)) {
            if (shift->of(*chosen.begin()).members == chosen.size()) edit.removeTable({kSection, table});
            else split(edit, project->project, *shift, table, [&](std::size_t index, const auto&) { return !chosen.contains(index); });
        }
        return {};
    });
}

Edit duplicateLuminaire(Shown project, std::size_t luminaire, Vec3d moveBy) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        const auto shift = matched(project->project, edit, {luminaire});
        if (!shift) return shift.error();
        const auto& place = shift->of(luminaire);
        edit.appendCopy({kSection, place.table}, {{"array", std::nullopt}, {"name", std::nullopt}, {"position", TomlValue(tidy(place.position + moveBy))}});
        return {};
    });
}

Edit addLuminaire(std::string type, Vec3d position) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        edit.append(kSection, {{"type", TomlValue(type)}, {"position", TomlValue(tidy(position))}});
        return {};
    });
}

std::vector<std::size_t> luminairesOfType(const Project& project, std::size_t type) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < project.scene.luminaires.size(); ++i)
        if (project.scene.luminaires[i].type == type) out.push_back(i);
    return out;
}

}  // namespace luxdeck::gui::edits
