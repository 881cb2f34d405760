#include "analysis/furniture/movable_object.h"

#include "analysis/furniture/detail_levels.h"
#include "analysis/furniture/fine_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace luxdeck {

namespace {

constexpr std::uint32_t kAll = std::numeric_limits<std::uint32_t>::max();

Error refused(std::string message) { return {ErrorCode::InvalidArgument, std::move(message), {}}; }

std::string movableNames(const Scene& scene) {
    std::string names;
    for (const auto& object : scene.objects)
        if (object.movable) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", object.name);
    return names.empty() ? "none is movable ([[furniture]] in the project says which are)" : "movable are " + names;
}

Result<std::uint32_t> findObject(const Scene& scene, const std::string& name) {
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
        if (scene.objects[i].name == name) return i;
    return refused(fmt::format("no object \"{}\"; {}", name, movableNames(scene)));
}

Result<void> checkVertices(const Scene& scene, std::uint32_t object, Box3d& bounds) {
    for (const auto& mesh : scene.meshes) {
        if (object != kAll && mesh.object != object) continue;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const bool good = isFinite(mesh.positions[i]) && (mesh.normals.empty() || isFinite(mesh.normals[i]));
            if (!good) return refused(fmt::format("vertex {} of \"{}\" is not finite", i, mesh.name));
        }
        bounds.extendBy(triangleBounds(mesh));
    }
    if (bounds.isEmpty()) return refused("the object has no triangles");
    return {};
}

Result<MovableObject> make(const Scene& scene, std::uint32_t object, const std::string& name, const ObjectSettings& settings) {
    if (!(settings.longestEdgeM > 0) || settings.levels < 0 || settings.levels > 6)
        return refused("the longest edge must be more than 0 m, levels of detail 0 .. 6");
    Box3d bounds;
    if (const auto good = checkVertices(scene, object, bounds); !good) return good.error();
    MovableObject out;
    out.name = name;
    out.pivot = pivotOf(bounds);
    bool emits = false;
    FineMesh fine(out, settings.longestEdgeM);
    for (const auto& mesh : scene.meshes) {
        if (object != kAll && mesh.object != object) continue;
        emits = emits || scene.materials[mesh.material].emits();
        if (const auto added = fine.add(scene, mesh); !added) return added.error();
    }
    if (out.triangles.empty()) return refused(fmt::format("\"{}\" has no triangles with an area", name));
    if (emits) out.warnings.push_back(fmt::format("{}: the light it gives is not in the room's volume and left out", name));
    findWorkingSurface(out);
    makeDetailLevels(out, settings.levels);
    return out;
}

}  // namespace

Result<MovableObject> makeMovableObject(const Scene& scene, const std::string& name, const ObjectSettings& settings) {
    const auto object = findObject(scene, name);
    if (!object) return object.error();
    return make(scene, *object, name, settings);
}

Result<MovableObject> makeMovableObject(const Scene& scene, const ObjectSettings& settings) {
    return make(scene, kAll, scene.objects.size() == 1 ? scene.objects.front().name : scene.name, settings);
}

Result<Scene> withoutObject(const Scene& scene, const std::string& name) {
    const auto object = findObject(scene, name);
    if (!object) return object.error();
    Scene out = scene;
    std::erase_if(out.meshes, [&](const Mesh& mesh) { return mesh.object == *object; });
    for (auto& mesh : out.meshes)
        if (mesh.object > *object) --mesh.object;
    out.objects.erase(out.objects.begin() + *object);
    out.hash = sceneHash(out);
    return out;
}

Scene withObjectAt(const Scene& scene, const Scene& from, const std::string& name, const MovableObject& object, const Pose& pose) {
    Scene out = scene;
    const auto place = object.placed(pose);
    const auto newObject = static_cast<std::uint32_t>(out.objects.size());
    const auto firstMaterial = static_cast<std::uint32_t>(out.materials.size());
    const bool own = !name.empty();  // else its materials are not the scene's
    out.objects.push_back({object.name, true});
    for (const auto& mesh : from.meshes) {
        if (!name.empty() && from.objects[mesh.object].name != name) continue;
        Mesh moved = mesh;
        moved.object = newObject;
        moveMesh(moved, object.pivot, place);
        if (!own) moved.material += firstMaterial;
        out.meshes.push_back(std::move(moved));
    }
    if (!own)
        for (auto material : from.materials) {
            // A model's pictures stay with it: its plain colours are what counts here.
            material.reflectanceTexture = material.metallicRoughnessTexture = material.emissionTexture = {};
            material.reflectancePattern = material.emissionPattern = material.mixPattern = -1;
            material.mixFirst += firstMaterial, material.mixSecond += firstMaterial;
            if (material.kind == MaterialKind::Mix) material.kind = MaterialKind::Matte;
            out.materials.push_back(std::move(material));
        }
    out.hash = sceneHash(out);
    return out;
}

}  // namespace luxdeck
