#include "engine/io/rad_reader.h"

#include "engine/io/placed_geometry.h"
#include "engine/io/rad_material.h"
#include "engine/io/rad_material_table.h"
#include "engine/io/rad_modifiers.h"
#include "engine/io/rad_sky.h"
#include "engine/io/rad_surface.h"
#include "engine/io/rad_texture.h"
#include "engine/io/rad_transform.h"
#include "engine/io/warning_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <memory>
#include <new>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace luxdeck {

namespace fs = std::filesystem;

namespace rad {

namespace {

/// What mirrors or refracts sharply shows every chord of a round surface.
bool isFine(const Material& m) {
    const bool polished = m.kind == MaterialKind::Ward && m.wardU < 0.05F && (m.specular.max() > 0.2F || m.specularTransmittance.max() > 0);
    return polished || m.kind == MaterialKind::Mirror || m.kind == MaterialKind::ThinGlass || m.kind == MaterialKind::Dielectric;
}

/// What a designer calls the thing that a surface is a part of: generators, xform and converters number the parts
/// behind a dot or at the end. A name that says too little gives way to the material's.
std::string objectName(const Primitive& surface) {
    auto name = surface.name;
    if (const auto dot = name.rfind('.'); dot != std::string::npos && dot > 0) name.erase(dot);
    while (!name.empty() && (std::isdigit(static_cast<unsigned char>(name.back())) != 0 || name.back() == '_')) name.pop_back();
    return name.size() < 3 ? surface.modifier : name;
}

/// Turns a stream of primitives into a scene.
class Builder {
public:
    Builder(CalLibrary& library, const GeometryPlacement& placement, const Limits& limits, ScenePart& part, WarningList& warnings)
        : limits_(limits), part_(part), warnings_(warnings), space_(spaceOf(placement)), table_(modifiers_, library, space_, part.scene, warnings_) {}

    Result<void> add(const Primitives& primitives) {
        for (const auto& p : primitives) {
            if (!isSurface(p.type)) {
                if (auto added = modifiers_.add(p); !added) return added;
                continue;
            }
            const auto modifier = modifiers_.find(p.modifier, p.place);
            if (!modifier) return modifier.error();
            if (auto added = p.type == "source" ? addSource(p, *modifier) : addSurface(p, *modifier); !added) return added;
        }
        return {};
    }

    void store() {
        storeRebased(part_, std::move(meshes_), {});
        if (unseen_ > 0) warnings_.add(fmt::format("{} surfaces without a material are left out: in Radiance rays pass through them as well", unseen_));
        for (const auto& text : warnings_.texts()) part_.scene.warnings.push_back(text);
    }

private:
    static FileSpace spaceOf(const GeometryPlacement& placement) {
        const auto m = placementMatrix(placement, placement.yUp);
        const Vec3d x(m[0][0], m[0][1], m[0][2]), y(m[1][0], m[1][1], m[1][2]), z(m[2][0], m[2][1], m[2][2]);
        return {m, std::cbrt(std::abs(x.dot(y.cross(z))))};
    }

    Result<void> addSource(const Primitive& p, int modifier) {
        if (auto sized = checkArguments(p); !sized) return sized;
        const auto chain = modifiers_.chain(modifier);
        if (chain.material == nullptr || !isEmitter(chain.material->type)) {
            warnings_.add("dark source", fmt::format("{}: the source {} gives no light: left out", p.place.text(), p.name));
            return {};
        }
        const auto mapped = mapMaterial(*chain.material, space_.metresPerUnit, space_.toScene, warnings_);
        if (!mapped) return mapped.error();
        const auto factor = table_.factor(chain.patterns, mapped->cone);
        if (!factor) return factor.error();
        return placeSource({p, mapped->material.emission, *factor, space_.toScene}, part_.scene.sky);
    }

    Result<void> addSurface(const Primitive& p, int modifier) {
        if (p.type == "mesh" || p.type == "instance")
            return p.place.error(ErrorCode::Unsupported, fmt::format("{} {} is a compiled file (.rtm, .oct), which is not read: expected the .rad or .obj that it was made of", p.type, p.name));
        const auto material = table_.find(modifier);
        if (!material) return material.error();
        if (!*material) {
            ++unseen_;
            return {};
        }
        const auto& m = part_.scene.materials[**material];
        auto mesh = tessellate(p, {space_.metresPerUnit, isFine(m), m.emits()});
        if (!mesh) return mesh.error();
        triangles_ += mesh->triangles.size();
        if (triangles_ > limits_.triangles) return p.place.error(ErrorCode::OutOfResources, fmt::format("the scene has more than {} triangles, expected fewer", limits_.triangles));
        const auto textures = modifiers_.chain(modifier).textures;
        if (p.type == "polygon") finishPolygon(p, textures, m.emits(), *mesh);
        else if (!textures.empty()) leaveTexture(*textures.front());
        append(p, **material, *mesh);
        return {};
    }

    void leaveTexture(const Primitive& texture) {
        const auto file = texture.strings.size() > 3 ? texture.strings[3] : std::string();
        if (file == "rev.cal" || file == "tmesh.cal" || file == "surf.cal") return;  // they smooth what is round here anyway
        warnings_.add("texture " + texture.name, fmt::format("{}: the texture {} {} is left out: surfaces keep their own normals", texture.place.text(), texture.type, texture.name));
    }

    void finishPolygon(const Primitive& p, const std::vector<const Primitive*>& textures, bool emits, SurfaceMesh& mesh) {
        if (mesh.triangles.empty()) return warnings_.add("no area", fmt::format("{}: polygon {} has no area: left out", p.place.text(), p.name));
        if (const double mismatch = areaMismatch(mesh); mismatch > 0.01)
            warnings_.add("crossing", fmt::format("{}: polygon {} crosses itself or is not flat: its triangles have {:.1f} % of another area", p.place.text(), p.name, 100 * mismatch));
        if (emits) mesh.normals.clear();
        if (textures.empty() || emits) return;
        const auto& t = mesh.triangles.front();
        const Vec3d normal = (mesh.positions[t[1]] - mesh.positions[t[0]]).cross(mesh.positions[t[2]] - mesh.positions[t[0]]).normalized();
        if (auto smoothed = smoothedNormals(*textures.front(), mesh.positions, normal)) mesh.normals = *std::move(smoothed);
        else leaveTexture(*textures.front());
    }

    void append(const Primitive& p, std::uint32_t material, const SurfaceMesh& surface) {
        const bool smooth = !surface.normals.empty();
        auto& target = meshOf(objectName(p), material, smooth);
        const auto first = static_cast<std::uint32_t>(target.positions.size());
        for (const auto& position : surface.positions) target.positions.push_back(position * space_.toScene);
        if (smooth) {
            std::vector<Vec3> normals;
            for (const auto& n : surface.normals) normals.emplace_back(n);
            if (!transformNormals(space_.toScene, normals)) normals.assign(normals.size(), Vec3(0, 0, 1));
            target.mesh.normals.insert(target.mesh.normals.end(), normals.begin(), normals.end());
        }
        const bool turned = mirrors(space_.toScene);
        for (const auto& t : surface.triangles) {
            auto& triangle = target.mesh.triangles.emplace_back(std::array{first + t[0], first + t[1], first + t[2]});
            if (turned) std::swap(triangle[1], triangle[2]);
        }
    }

    PlacedMesh& meshOf(const std::string& name, std::uint32_t material, bool smooth) {
        auto& scene = part_.scene;
        const auto [object, isNewObject] = objects_.try_emplace(name, static_cast<std::uint32_t>(scene.objects.size()));
        if (isNewObject) scene.objects.push_back({name, false});
        const auto [known, isNew] = meshIndices_.try_emplace({object->second, material, smooth}, meshes_.size());
        if (isNew) {
            auto& mesh = meshes_.emplace_back().mesh;
            mesh.name = name;
            mesh.object = object->second;
            mesh.material = material;
        }
        return meshes_[known->second];
    }

    Limits limits_;
    ScenePart& part_;
    WarningList& warnings_;
    FileSpace space_;
    Modifiers modifiers_;
    MaterialTable table_;
    std::map<std::string, std::uint32_t> objects_;
    std::map<std::tuple<std::uint32_t, std::uint32_t, bool>, std::size_t> meshIndices_;
    std::vector<PlacedMesh> meshes_;
    std::size_t triangles_ = 0, unseen_ = 0;
};

std::vector<fs::path> foldersOf(const std::vector<fs::path>& files) {
    std::vector<fs::path> folders;
    for (const auto& file : files) {
        auto folder = folderOf(file);
        if (std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(std::move(folder));
    }
    return folders;
}

Result<ScenePart> read(const std::vector<fs::path>& files, const GeometryPlacement& placement, const Limits& limits) {
    CalLibrary library(CalLibrary::withRayPath(foldersOf(files)));
    WarningList warnings;
    Stream stream(library, limits, warnings);
    std::vector<Stream::Shared> primitives;  // all of them stay: definitions are used by later files
    for (const auto& file : files) {
        auto read = stream.readFile(file);
        if (!read) return read.error();
        primitives.push_back(*std::move(read));
    }
    ScenePart part;
    part.scene.name = files.front().stem().string();
    part.scene.weights = kRadianceWeights;
    Builder builder(library, placement, limits, part, warnings);
    for (const auto& some : primitives)
        if (auto added = builder.add(*some); !added) return added.error();
    builder.store();
    if (!allFinite(part.scene)) return Error{ErrorCode::Parse, "has coordinates beyond the range of floats once in metres", files.front().string()};
    return part;
}

}  // namespace

}  // namespace rad

Result<ScenePart> readRad(const std::vector<fs::path>& files, const GeometryPlacement& placement, const rad::Limits& limits) {
    if (files.empty()) return Error{ErrorCode::InvalidArgument, "no file is named, expected one or more", {}};
    try {
        return rad::read(files, placement, limits);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfResources, "memory ran out while reading", files.front().string()};
    } catch (const std::length_error&) {
        return Error{ErrorCode::OutOfResources, "memory ran out while reading", files.front().string()};
    }
}

}  // namespace luxdeck
