#include "engine/io/project_keys.h"
#include "engine/core/file.h"
#include "engine/io/project_sections.h"

#include "engine/core/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace luxdeck::project {

namespace {

enum class UpAxis { Y, Z };

constexpr TomlChoice<double> kUnits[] = {
    {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", kMetresPerInch}, {"ft", kMetresPerFoot}};
constexpr TomlChoice<UpAxis> kUpAxes[] = {{"z", UpAxis::Z}, {"y", UpAxis::Y}};
constexpr NumberRange kScale{.low = 1e-6, .high = 1e6};
constexpr NumberRange kTurn{.low = -3600, .high = 3600};

/// Scaled, turned about z, then moved; row vectors.
Matrix4d placementMatrix(double scale, double rotationDeg, const Vec3d& translation) {
    const double turn = std::remainder(rotationDeg, 360.0) * kDegree;
    const double c = scale * std::cos(turn), s = scale * std::sin(turn);
    return {c, s, 0, 0, -s, c, 0, 0, 0, 0, scale, 0, translation.x, translation.y, translation.z, 1};
}

/// `file`, `unit`, `up` and `scale`, which geometry and furniture share, and where the file goes.
GeometrySpec readPlacedFile(const TomlTable& table, const std::filesystem::path& folder, Key translation, Key rotation) {
    GeometrySpec spec;
    spec.file = readFileReference(table, "file", folder);
    const auto extension = lowerExtension(spec.file.path);
    const bool gltf = extension == ".glb" || extension == ".gltf";
    spec.placement.metresPerUnit = table.choice<double>("unit", 1.0, kUnits);
    if (extension == ".obj" && !table.has("unit"))
        table.error(ErrorCode::Parse, "file",
                    "unit is missing: an OBJ file does not say what its numbers are, expected unit = \"m\", \"cm\", \"mm\", \"in\" or \"ft\"");
    const auto up = table.choice<UpAxis>("up", gltf ? UpAxis::Y : UpAxis::Z, kUpAxes);
    if (gltf && up == UpAxis::Z)
        table.error(ErrorCode::InvalidArgument, "up", "up is \"z\", expected \"y\": in glTF y is always up");
    spec.placement.yUp = up == UpAxis::Y;
    spec.placement.transform = placementMatrix(table.number("scale", kScale, 1.0), table.number(rotation, kTurn, 0.0),
                                               table.vector(translation, Vec3d(0, 0, 0)));
    return spec;
}

Result<ScenePart> readPart(const GeometrySpec& spec, const std::string& subject) {
    auto part = readSceneFile(spec.file.path, spec.placement);
    if (!part) return inNamedFile(part.error(), subject, spec.file);
    for (auto& warning : part->scene.warnings) warning = fmt::format("{}: {}", spec.file.shown, warning);
    return part;
}

/// All of its parts, about the one pivot.
void moveObject(Scene& scene, std::uint32_t object, const Pose& pose) {
    Box3d bounds;
    for (const auto& mesh : scene.meshes)
        if (mesh.object == object) bounds.extendBy(triangleBounds(mesh));
    if (bounds.isEmpty()) return;
    const auto pivot = pivotOf(bounds);
    const auto place = placementOf(pivot, pose);
    for (auto& mesh : scene.meshes)
        if (mesh.object == object) moveMesh(mesh, pivot, place);
}

Result<void> placeObject(Scene& scene, const FurnitureSpec& furniture) {
    std::vector<std::uint32_t> found;
    std::vector<std::string> names;
    for (auto& object : scene.objects) {
        names.push_back(object.name);
        if (object.name != furniture.name) continue;
        object.movable = furniture.movable;
        found.push_back(static_cast<std::uint32_t>(&object - scene.objects.data()));
    }
    const bool moves = furniture.pose != Pose{};
    if (moves && found.size() > 1)
        return Error{ErrorCode::InvalidArgument,
                     fmt::format("[[furniture]]: {} objects in the geometry are called {}, expected one to move", found.size(), inQuotes(furniture.name)),
                     furniture.where};
    if (moves && !found.empty()) moveObject(scene, found.front(), furniture.pose);
    if (!found.empty()) return {};
    return Error{ErrorCode::InvalidArgument,
                 fmt::format("[[furniture]]: no object {} in the geometry; {}", inQuotes(furniture.name),
                             suggestion(furniture.name, names)),
                 furniture.where};
}

/// One object of all that a furniture file holds: a chair's seat does not move without its legs.
void makeOneObject(ScenePart& part, const std::string& name, bool movable) {
    part.scene.objects = {SceneObject{name, movable}};
    for (auto& mesh : part.scene.meshes) {
        mesh.object = 0;
        mesh.name = name;
    }
    if (movable && !part.scene.luminaires.empty())
        part.scene.warnings.push_back(fmt::format("{}: its lights stay where they are when it is moved", name));
}

}  // namespace

std::vector<GeometrySpec> readGeometry(const TomlTable& root, const std::filesystem::path& folder) {
    std::vector<GeometrySpec> geometry;
    root.each("geometry", kGeometry, [&](const TomlTable& table) {
        geometry.push_back(readPlacedFile(table, folder, "translate", "rotate_z_deg"));
    });
    return geometry;
}

std::vector<FurnitureSpec> readFurniture(const TomlTable& root, const std::filesystem::path& folder) {
    std::vector<FurnitureSpec> furniture;
    UniqueNames names;
    root.each("furniture", kFurniture, [&](const TomlTable& table) {
        FurnitureSpec spec;
        spec.where = table.where();
        spec.movable = table.flag("movable", true);
        if (table.has("object")) {
            for (const auto* key : {"file", "name", "position", "rotation_deg", "unit", "up", "scale"})
                table.refuseBoth("object", key);
            spec.name = table.text("object");
            spec.pose = {table.vector("move", Vec3d(0, 0, 0)), table.number("turn_deg", kTurn, 0.0)};
            names.add(table, "object", spec.name);
        } else if (table.has("file")) {
            for (const auto* key : {"move", "turn_deg"}) table.refuseBoth("file", key);
            spec.file = readPlacedFile(table, folder, "position", "rotation_deg");
            spec.name = table.text("name", "");
            if (!spec.name.empty()) names.add(table, "name", spec.name);
        } else {
            table.error(ErrorCode::Parse, "", "object or file is missing");
        }
        furniture.push_back(std::move(spec));
    });
    return furniture;
}

Result<std::vector<SceneCamera>> loadGeometry(Scene& scene, const ProjectSpec& spec) {
    std::vector<SceneCamera> cameras;
    for (const auto& geometry : spec.geometry) {
        auto part = readPart(geometry, "geometry");
        if (!part) return part.error();
        std::move(part->cameras.begin(), part->cameras.end(), std::back_inserter(cameras));
        append(scene, std::move(*part));
    }
    for (const auto& furniture : spec.furniture)
        if (!furniture.file)
            if (auto placed = placeObject(scene, furniture); !placed) return placed.error();

    std::set<std::string> taken;
    for (const auto& object : scene.objects) taken.insert(object.name);
    for (const auto& furniture : spec.furniture) taken.insert(furniture.name);
    for (const auto& furniture : spec.furniture) {
        if (!furniture.file) continue;
        auto name = furniture.name;
        const auto stem = furniture.file->file.path.stem().string();
        for (int i = 1; name.empty() || (furniture.name.empty() && !taken.insert(name).second); ++i)
            name = fmt::format("{} {}", stem, i);
        auto part = readPart(*furniture.file, fmt::format("furniture {}", inQuotes(name)));
        if (!part) return part.error();
        makeOneObject(*part, name, furniture.movable);
        append(scene, std::move(*part));
    }
    return cameras;
}

}  // namespace luxdeck::project
