#include "engine/io/scene_files.h"

#include "engine/io/gltf_document.h"
#include "engine/io/gltf_instances.h"
#include "engine/io/gltf_light.h"
#include "engine/io/gltf_material.h"
#include "engine/io/gltf_mesh.h"
#include "engine/io/gltf_nodes.h"
#include "engine/io/gltf_solid.h"
#include "engine/io/placed_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

namespace luxdeck {

namespace {

using gltf::Document;
using gltf::JsonView;
using gltf::PlacedNode;

/// A small file may place one mesh any number of times. Beyond this many vertices or triangles in all it is
/// a model for engine/massive, or a trap.
constexpr std::uint64_t kMaxPlaced = 1ULL << 25;

/// A mesh of the file is read when a node first places it.
class SceneBuilder {
public:
    SceneBuilder(Document& document, ScenePart& part)
        : document_(document), part_(part), materials_(document, part.scene), lights_(document, part.scene) {}

    void build(const Matrix4d& placement) {
        const auto nodes = gltf::placeNodes(document_, placement);
        if (failed() || !sizeIsBearable(nodes)) return;
        materials_.setMetresPerUnit(std::cbrt(std::abs(placement.determinant())));
        materials_.readAll();
        for (const auto& node : nodes) {
            if (failed()) return;
            addNode(node);
        }
        warnOfHidden();
        if (!failed()) storeRebased(part_, std::move(meshes_), lights_.positions());
    }

private:
    [[nodiscard]] bool failed() const { return document_.failure.failed(); }
    JsonView json(const PlacedNode& node) { return document_.root()["nodes"].at(node.node); }

    bool sizeIsBearable(const std::vector<PlacedNode>& nodes) {
        const auto list = document_.root()["meshes"];
        std::vector<gltf::MeshSize> sizes;
        for (std::size_t i = 0; i < list.size(); ++i) sizes.push_back(meshSize(document_, list.at(i)));
        std::uint64_t vertices = 0, triangles = 0;
        for (const auto& node : nodes) {
            const auto mesh = json(node)["mesh"].index(list.size(), "meshes", false);
            const auto count = instanceCount(document_, json(node));
            if (failed()) return false;
            if (mesh < 0 || !node.visible) continue;
            // Each below 2^32, as accessors are checked against the file's size.
            vertices += count * sizes[static_cast<std::size_t>(mesh)].vertices;
            triangles += count * sizes[static_cast<std::size_t>(mesh)].triangles;
            if (std::max({vertices, triangles, count}) <= kMaxPlaced) continue;
            json(node).fail(fmt::format("with this node the scene has more than {} vertices or triangles", kMaxPlaced),
                            ErrorCode::OutOfResources);
            return false;
        }
        return !failed();
    }

    void addNode(const PlacedNode& node) {
        const auto view = json(node);
        const std::string name = nodeName(view);
        const auto meshes = document_.root()["meshes"];
        const auto mesh = view["mesh"].index(meshes.size(), "meshes", false);
        if (mesh >= 0 && node.visible) addMesh(static_cast<std::size_t>(mesh), view, name, node.world);
        if (view["skin"].present()) document_.warnings.add("skin", "skins are left out: meshes keep their base pose");
        if (view["camera"].present()) addCamera(view["camera"], name, node.world);
        const bool shines =
            view.extension("KHR_lights_punctual").present() || view.extension("EXT_lights_ies").present();
        if (node.visible) lights_.readNode(view, name, node.world);
        else if (mesh >= 0 || shines) hidden_.push_back(name);
    }

    void warnOfHidden() {
        if (hidden_.empty()) return;
        std::string names;
        for (std::size_t i = 0; i < std::min<std::size_t>(hidden_.size(), 3); ++i)
            names += fmt::format("{}'{}'", i == 0 ? "" : ", ", hidden_[i]);
        document_.warnings.add(fmt::format("{} nodes are hidden by KHR_node_visibility and left out: {}{}",
                                           hidden_.size(), names, hidden_.size() > 3 ? " ..." : ""));
    }

    const std::vector<gltf::Primitive>& primitives(std::size_t mesh) {
        const auto [known, isNew] = read_.try_emplace(mesh);
        if (!isNew) return known->second;
        known->second = readMesh(document_, document_.root()["meshes"].at(mesh), materials_);
        if (!failed()) settleSolids(known->second, document_.root()["meshes"].at(mesh));
        return known->second;
    }

    /// Only what is closed has an inside: a window exported as a plane with a thickness stays a pane.
    void settleSolids(std::vector<gltf::Primitive>& parts, const JsonView& mesh) {
        std::map<std::uint32_t, std::vector<const gltf::Primitive*>> solids;
        for (const auto& part : parts)
            if (materials_.isSolid(part.material)) solids[part.material].push_back(&part);
        for (const auto& [material, surfaces] : solids) {
            const auto shell = gltf::shellOf(surfaces);
            if (shell == gltf::Shell::Outward) continue;
            const bool open = shell == gltf::Shell::Open;
            const char* what = open ? "has a thickness (KHR_materials_volume) but is not closed: taken as a thin pane"
                                    : "is a solid turned inside out: turned round";
            document_.warnings.add(fmt::format("mesh '{}' of material '{}' {}", mesh["name"].text(mesh.path()),
                                               part_.scene.materials[material].name, what));
            for (auto& part : parts) {
                if (part.material != material) continue;
                if (open) part.material = materials_.paneInstead(material);
                else part.turnRound();
            }
        }
    }

    /// Each instance is an object of its own: they can be moved and looked at one by one.
    void addMesh(std::size_t mesh, const JsonView& node, const std::string& nodeName, const Matrix4d& world) {
        if (primitives(mesh).empty() || failed()) return;
        const auto places = instancePlaces(document_, node, world);
        const auto name = node["name"].text(document_.root()["meshes"].at(mesh)["name"].text(nodeName));
        const bool many = node.extension("EXT_mesh_gpu_instancing").present();
        for (std::size_t i = 0; i < places.size() && !failed(); ++i)
            placeMesh(mesh, node, many ? fmt::format("{} {}", name, i + 1) : name, places[i]);
    }

    void placeMesh(std::size_t mesh, const JsonView& node, const std::string& name, const Matrix4d& world) {
        const auto object = static_cast<std::uint32_t>(part_.scene.objects.size());
        part_.scene.objects.push_back({name, false});
        for (const auto& primitive : primitives(mesh)) {
            auto& placed = meshes_.emplace_back();
            placed.mesh.name = part_.scene.objects.back().name;
            placed.mesh.object = object;
            placed.mesh.material = primitive.material;
            placed.mesh.uvs = primitive.uvs;
            placed.mesh.triangles = primitive.triangles;
            if (mirrors(world))
                for (auto& triangle : placed.mesh.triangles) std::swap(triangle[1], triangle[2]);
            placed.mesh.normals = primitive.normals;
            if (!transformNormals(world, placed.mesh.normals)) {
                placed.mesh.normals.clear();
                document_.warnings.add("normals " + name, fmt::format("'{}' has normals that are zero or not finite: it is shaded flat", name));
            }
            if (!placePositions(primitive, world, placed.positions)) return node.fail("its transform takes vertices out of the range of floats");
        }
    }

    static bool placePositions(const gltf::Primitive& primitive, const Matrix4d& world, std::vector<Vec3d>& positions) {
        positions.reserve(primitive.positions.size());
        for (const auto& local : primitive.positions) {
            positions.push_back(Vec3d(local) * world);
            if (!isFinite(Vec3(positions.back()))) return false;
        }
        return true;
    }

    void addCamera(const JsonView& reference, const std::string& name, const Matrix4d& world) {
        const auto cameras = document_.root()["cameras"];
        const auto index = reference.index(cameras.size(), "cameras");
        if (failed()) return;
        const auto camera = cameras.at(static_cast<std::size_t>(index));
        if (camera["type"].text() != "perspective")
            return document_.warnings.add(fmt::format("camera '{}' is not perspective: it is left out", name));
        const double fovRad = camera["perspective"]["yfov"].number();
        Vec3d direction, up;
        world.multDirMatrix(Vec3d(0, 0, -1), direction);
        world.multDirMatrix(Vec3d(0, 1, 0), up);
        const Vec3d position(world[3][0], world[3][1], world[3][2]);
        if (!(fovRad > 0 && fovRad < kPiD)) return camera["perspective"]["yfov"].fail(fmt::format("is {:g}, expected 0 .. pi", fovRad));
        if (!(direction.length() > 0) || !(up.length() > 0) || !isFinite(position))
            return document_.warnings.add(fmt::format("camera '{}' has no direction: it is left out", name));
        part_.cameras.push_back({camera["name"].text(name), position, direction.normalized(), up.normalized(), fovRad / kDegree});
    }

    Document& document_;
    ScenePart& part_;
    gltf::MaterialReader materials_;
    gltf::LightReader lights_;
    std::map<std::size_t, std::vector<gltf::Primitive>> read_;  // by mesh of the file
    std::vector<PlacedMesh> meshes_;
    std::vector<std::string> hidden_;  // nodes that would be seen
};

}  // namespace

Result<ScenePart> readGltf(const std::filesystem::path& path, const GeometryPlacement& placement) {
    try {
        auto document = Document::open(path);
        if (!document) return document.error();
        ScenePart part;
        part.scene.name = path.stem().string();
        SceneBuilder(**document, part).build(placementMatrix(placement, true));
        if ((*document)->failure.failed()) return (*document)->failure.error();
        if (part.scene.meshes.empty() && part.scene.luminaires.empty() && part.scene.sky.suns.empty())
            (*document)->warnings.add("the file has neither surfaces nor lights");
        for (const auto& text : (*document)->warnings.texts()) part.scene.warnings.push_back(path.filename().string() + ": " + text);
        return part;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfResources, "memory ran out while reading", path.string()};
    } catch (const std::length_error&) {
        return Error{ErrorCode::OutOfResources, "memory ran out while reading", path.string()};
    }
}

}  // namespace luxdeck
