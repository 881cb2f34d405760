#include "gui/session/edit_text.h"
#include "gui/session/edits.h"

#include "engine/core/file.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace luxdeck::gui::edits {

namespace {

constexpr const char* kSection = "furniture";

Vec3d turned(const Vec3d& v, double degrees) {
    const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

/// The [[furniture]] that says of an object, if there is one: by its name, or, where a file has none, by its turn.
std::optional<std::size_t> tableOf(const ProjectEdit& edit, const Project& project, std::size_t object) {
    const auto& name = project.scene.objects[object].name;
    if (const auto at = edit.find(kSection, "object", name)) return at;
    std::vector<std::size_t> files;
    for (std::size_t i = 0; i < edit.count(kSection); ++i)
        if (edit.has({kSection, i}, "file")) files.push_back(i);
    const auto first = project.scene.objects.size() - std::min(files.size(), project.scene.objects.size());  // theirs come last
    return object >= first ? std::optional(files[object - first]) : std::nullopt;
}

Result<std::size_t> objectNamed(const Project& project, const std::string& name) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < project.scene.objects.size(); ++i) {
        if (project.scene.objects[i].name != name) continue;
        if (found) return Error{ErrorCode::InvalidArgument, fmt::format("several objects are called \"{}\", expected one to move", name), {}};
        found = i;
    }
    if (!found) return Error{ErrorCode::InvalidArgument, fmt::format("there is no object \"{}\"", name), {}};
    return *found;
}

/// The pivot of an object as it would be turned back by so many degrees, about any vertical [m, re-based].
Vec3d pivotTurnedBack(const Scene& scene, std::size_t object, double degrees) {
    Box3d bounds;
    for (const auto& mesh : scene.meshes) {
        if (mesh.object != object) continue;
        if (degrees == 0) bounds.extendBy(triangleBounds(mesh));
        else
            for (const auto& triangle : mesh.triangles)
                for (const auto v : triangle) bounds.extendBy(turned(Vec3d(mesh.positions[v]), -degrees));
    }
    return bounds.isEmpty() ? Vec3d(0, 0, 0) : pivotOf(bounds);
}

double wholeTurn(double degrees) { return tidy(std::remainder(degrees, 360.0)); }

/// move and turn_deg are about the pivot of the object as the geometry has it: the new pose comes after that one.
///
/// With the old pose x = R1 (x0 - p0) + p0 + m1, and the pivot q of what is seen turned back, p0 + m1 = R1 q. The new one
/// turns about the pivot p1 of what is seen: R2 (x - p1) + p1 + m2 = R2 R1 (x0 - p0) + p0 + [m1 + R2 (R1 q - p1) + p1 + m2 - R1 q].
std::vector<KeyChange> movedInGeometry(const ProjectEdit& edit, const TomlPlace& table, const Scene& scene, std::size_t object, const Pose& pose) {
    const auto oldMove = vectorAt(edit, table, "move", Vec3d(0, 0, 0));
    const double oldTurn = edit.number(table, "turn_deg").value_or(0);
    const auto stood = turned(pivotTurnedBack(scene, object, oldTurn), oldTurn), pivot = pivotTurnedBack(scene, object, 0);
    const Vec3d move = oldMove + turned(stood - pivot, pose.turnDeg) + pivot + pose.moveM - stood;
    const double turn = wholeTurn(oldTurn + pose.turnDeg);
    std::vector<KeyChange> changes{{"move", TomlValue(tidy(move))}};
    if (turn != 0 || edit.has(table, "turn_deg")) changes.push_back({"turn_deg", TomlValue(turn)});
    return changes;
}

std::vector<KeyChange> movedFile(const ProjectEdit& edit, const TomlPlace& table, const Scene& scene, std::size_t object, const Pose& pose) {
    const auto pivot = pivotTurnedBack(scene, object, 0) + scene.origin;
    const auto position = vectorAt(edit, table, "position", Vec3d(0, 0, 0));
    std::vector<KeyChange> changes{{"position", TomlValue(tidy(turned(position - pivot, pose.turnDeg) + pivot + pose.moveM))}};
    if (pose.turnDeg != 0) changes.push_back({"rotation_deg", TomlValue(wholeTurn(edit.number(table, "rotation_deg").value_or(0) + pose.turnDeg))});
    return changes;
}

}  // namespace

Edit moveObject(Shown project, std::string object, Pose pose) {
    return [=](const std::string& text) -> Result<std::string> {
        // Where it stands is taken from the scene, so that has to be this text's.
        if (contentHash(text) != project->project.fileHash)
            return Error{ErrorCode::InvalidArgument, "the project has just changed, expected to move \"" + object + "\" as it is shown: try again", {}};
        auto edit = ProjectEdit::of(text);
        if (!edit) return edit.error();
        const auto& scene = project->project.scene;
        const auto index = objectNamed(project->project, object);
        if (!index) return index.error();
        const auto at = tableOf(*edit, project->project, *index);
        const TomlPlace table{kSection, at.value_or(std::numeric_limits<std::size_t>::max())};
        auto changes = edit->has(table, "file") ? movedFile(*edit, table, scene, *index, pose) : movedInGeometry(*edit, table, scene, *index, pose);
        if (at) apply(*edit, table, changes);
        else changes.insert(changes.begin(), {"object", TomlValue(object)}), edit->append(kSection, std::move(changes));
        return edit->text();
    };
}

Edit setMovable(Shown project, std::string object, bool movable) {
    return textEdit([=](ProjectEdit& edit) -> Result<void> {
        const auto index = objectNamed(project->project, object);
        if (!index) return index.error();
        if (const auto at = tableOf(edit, project->project, *index)) edit.set({kSection, *at}, "movable", movable);
        else edit.append(kSection, {{"object", TomlValue(object)}, {"movable", TomlValue(movable)}});
        return {};
    });
}

}  // namespace luxdeck::gui::edits
