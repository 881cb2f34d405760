#include "engine/io/scene_files.h"

#include "engine/core/file.h"
#include "engine/io/obj_colours.h"
#include "engine/io/obj_files.h"
#include "engine/io/obj_material.h"
#include "engine/io/obj_polygon.h"
#include "engine/io/obj_text.h"
#include "engine/io/placed_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <new>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace luxdeck {

namespace {

using obj::Words;

constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// One corner of a face: indices from 0 into the file's v, vt and vn; kNone where not given.
struct Corner {
    std::uint32_t position = kNone, uv = kNone, normal = kNone;
};

/// A mesh that grows: all faces of one object with one material that give the same data.
struct GrowingMesh {
    std::uint32_t object = 0, material = 0;
    bool hasUvs = false, hasNormals = false;
    bool coloured = false;  ///< uv is not the file's but a number of VertexColours
    std::vector<Corner> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Where a corner became a vertex of a mesh; entries of one position are chained.
struct KnownVertex {
    std::uint32_t mesh = 0, vertex = 0, uv = kNone, normal = kNone, next = kNone;
};

/// A position that is used in more ways than this gets doubled vertices, which cost little; an endless chain would
/// make reading take time with the square of the file.
constexpr int kLongestChain = 16;

class ObjReader {
public:
    ObjReader(const std::filesystem::path& path, ScenePart& part, WarningList& warnings)
        : path_(path), part_(part), warnings_(warnings), library_(part.scene, warnings) {}

    Result<void> read(std::string_view text) {
        obj::Lines lines(text);
        while (lines.next()) {
            line_ = lines.number();
            Words words(lines.line());
            if (const auto key = words.next(); !key.empty()) readLine(key, words);
            if (error_) return *error_;
        }
        return {};
    }

    void store(const Matrix4d& placement) {
        colours_.finish(part_.scene, warnings_);
        std::vector<PlacedMesh> placed;
        for (auto& mesh : meshes_) {
            placed.push_back(place(mesh, placement));
            mesh = {};
        }
        storeRebased(part_, std::move(placed), {});
    }

private:
    void fail(const std::string& message, ErrorCode code = ErrorCode::Parse) {
        if (!error_) error_ = Error{code, message, fmt::format("{}:{}", path_.string(), line_)};
    }

    void readLine(std::string_view key, Words& words) {
        if (key == "v") readPosition(words);
        else if (key == "vt") readUv(words);
        else if (key == "vn") readNormal(words);
        else if (key == "f" || key == "fo") readFace(words);
        else if (key == "g" || key == "o") selectObject(words);
        else if (key == "usemtl") material_ = std::string(words.remainder()), mesh_ = kNone;
        else if (key == "mtllib") readLibrary(words);
        else if (key == "p" || key == "l")
            warnings_.add("lines", fmt::format("line {}: points and lines have no surface: left out", line_));
        else if (key != "s" && key != "mg" && key != "lod" && key != "vp")
            warnings_.add(fmt::format("key {}", key), fmt::format("line {}: '{}' is left out", line_, key));
    }

    /// The next number of a line.
    double number(Words& words, const char* key) {
        Words look = words;
        const auto value = words.number();
        if (!value) fail(fmt::format("'{}' has '{}', expected a number", key, look.next()));
        return value.value_or(0);
    }

    void readPosition(Words& words) {
        const Vec3d p{number(words, "v"), number(words, "v"), number(words, "v")};  // braces: read in this order
        if (!isFinite(p))
            fail(fmt::format("vertex {} is ({}, {}, {}), expected finite numbers", positions_.size() + 1, p.x, p.y, p.z));
        positions_.push_back(p);
        readColour(words);
    }

    /// r g b after x y z; one number there is the weight w of a curve's point, and says nothing.
    void readColour(Words& words) {
        std::array<double, 3> c{};
        for (auto& value : c) {
            const auto number = words.number();
            if (!number || !std::isfinite(*number)) return;
            value = *number;
        }
        colours_.add(positions_.size() - 1, Vec3(Vec3d(c[0], c[1], c[2])));
    }

    void readNormal(Words& words) {  // one that is not finite makes its mesh flat: see place()
        const Vec3d n{number(words, "vn"), number(words, "vn"), number(words, "vn")};
        normals_.push_back(Vec3(n));
    }

    void readUv(Words& words) {
        double u = number(words, "vt");
        double v = words.atEnd() ? 0 : number(words, "vt");
        if (!std::isfinite(u) || !std::isfinite(v)) {
            warnings_.add("vt", fmt::format("line {}: texture coordinates are not finite, taken as 0", line_));
            u = v = 0;
        }
        uvs_.push_back({static_cast<float>(u), static_cast<float>(1 - v)});  // ours runs down from the top row
    }

    void selectObject(Words& words) {
        object_ = std::string(words.remainder());
        mesh_ = kNone;
    }

    void readLibrary(Words& words) {
        for (const auto& name : files_.libraryNames(path_.parent_path(), words.remainder())) {
            const auto file = files_.find(path_.parent_path(), name);
            if (!file) return fail(fmt::format("mtllib {}", file.error().message), file.error().code);
            if (!file->note.empty()) warnings_.add(fmt::format("line {}: mtllib {}", line_, file->note));
            if (!libraries_.insert(file->path.string()).second) continue;  // each counts once
            if (const auto result = library_.read(file->path); !result && !error_) error_ = result.error();
        }
    }

    /// An index as the file gives it (from 1, or negative from the end), as one from 0.
    bool resolve(std::string_view text, std::size_t count, const char* what, std::uint32_t& index) {
        long long value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || value == 0) {
            fail(fmt::format("face has '{}' as an index of {}, expected a whole number other than 0", text, what));
            return false;
        }
        const long long fromZero = value > 0 ? value - 1 : static_cast<long long>(count) + value;
        if (fromZero < 0 || fromZero >= static_cast<long long>(count)) {
            fail(fmt::format("face names {} {}, but there are {} so far", what, value, count));
            return false;
        }
        index = static_cast<std::uint32_t>(fromZero);
        return true;
    }

    /// v, v/vt, v//vn or v/vt/vn.
    bool readCorner(std::string_view word, Corner& corner) {
        const auto first = word.find('/');
        if (!resolve(word.substr(0, first), positions_.size(), "v", corner.position)) return false;
        if (first == std::string_view::npos) return true;
        const auto rest = word.substr(first + 1);
        const auto second = rest.find('/');
        const auto uv = rest.substr(0, second);
        if (!uv.empty() && !resolve(uv, uvs_.size(), "vt", corner.uv)) return false;
        if (second == std::string_view::npos || second + 1 == rest.size()) return true;
        return resolve(rest.substr(second + 1), normals_.size(), "vn", corner.normal);
    }

    void readFace(Words& words) {
        corners_.clear();
        for (auto word = words.next(); !word.empty(); word = words.next()) {
            Corner corner;
            if (!readCorner(word, corner)) return;
            corners_.push_back(corner);
        }
        if (corners_.size() < 3)
            return warnings_.add("small", fmt::format("line {}: a face of {} corners is left out", line_, corners_.size()));
        polygon_.clear();
        for (const auto& corner : corners_) polygon_.push_back(positions_[corner.position]);
        if (!obj::triangulate(polygon_, triangles_))
            return fail(fmt::format("a concave face of {} corners, expected at most {}", corners_.size(), obj::kMaxConcaveCorners),
                        ErrorCode::Unsupported);
        const auto all = [&](auto member) {
            return std::all_of(corners_.begin(), corners_.end(), [&](const Corner& c) { return c.*member != kNone; });
        };
        const bool coloured = takeColour();
        const std::uint32_t mesh = currentMesh(!coloured && all(&Corner::uv), all(&Corner::normal), coloured);
        for (const auto& triangle : triangles_)
            meshes_[mesh].triangles.push_back({vertex(mesh, corners_[triangle[0]]), vertex(mesh, corners_[triangle[1]]),
                                               vertex(mesh, corners_[triangle[2]])});
    }

    /// Gives the face's corners the number of its colour, where that is what its material is known by.
    bool takeColour() {
        if (!colours_.any()) return false;
        const auto has = [&](const Corner& c) { return colours_.has(c.position); };
        if (!std::all_of(corners_.begin(), corners_.end(), has)) {
            if (std::any_of(corners_.begin(), corners_.end(), has))
                warnings_.add("half coloured", fmt::format("line {}: not all corners of a face have a vertex colour: "
                                                           "the others' are left out", line_));
            return false;
        }
        if (library_.describes(material_)) {
            warnings_.add("coloured twice", fmt::format("line {}: vertex colours are left out, as a library describes "
                                                        "the material", line_));
            return false;
        }
        std::vector<std::uint32_t> vertices;
        for (const auto& corner : corners_) vertices.push_back(corner.position);
        const auto colour = colours_.face(vertices);
        for (auto& corner : corners_) corner.uv = colour;
        return true;
    }

    std::uint32_t colouredMaterial() {
        const auto [known, isNew] = colouredMaterials_.try_emplace(material_, 0);
        if (isNew) known->second = colours_.addMaterial(part_.scene, material_);
        return known->second;
    }

    /// The mesh that takes faces now; faces with and without normals or texture coordinates go to different ones.
    std::uint32_t currentMesh(bool hasUvs, bool hasNormals, bool coloured) {
        if (mesh_ != kNone && meshes_[mesh_].hasUvs == hasUvs && meshes_[mesh_].hasNormals == hasNormals &&
            meshes_[mesh_].coloured == coloured)
            return mesh_;
        const auto material = coloured ? colouredMaterial() : library_.find(material_);
        const auto [object, isNewObject] = objects_.try_emplace(object_, static_cast<std::uint32_t>(part_.scene.objects.size()));
        if (isNewObject) part_.scene.objects.push_back({object_.empty() ? path_.stem().string() : object_, false});
        const auto [known, isNew] = meshIndices_.try_emplace({object->second, material, hasUvs, hasNormals},
                                                             static_cast<std::uint32_t>(meshes_.size()));
        if (isNew) meshes_.push_back({object->second, material, hasUvs, hasNormals, coloured, {}, {}});
        return mesh_ = known->second;
    }

    /// The vertex of a mesh that stands for a corner.
    std::uint32_t vertex(std::uint32_t mesh, Corner corner) {
        if (!meshes_[mesh].hasUvs && !meshes_[mesh].coloured) corner.uv = kNone;
        if (!meshes_[mesh].hasNormals) corner.normal = kNone;
        if (heads_.size() < positions_.size()) heads_.resize(std::max(positions_.size(), 2 * heads_.size()), kNone);
        int steps = 0;
        for (std::uint32_t i = heads_[corner.position]; i != kNone && steps < kLongestChain; i = known_[i].next, ++steps)
            if (known_[i].mesh == mesh && known_[i].uv == corner.uv && known_[i].normal == corner.normal) return known_[i].vertex;
        auto& vertices = meshes_[mesh].vertices;
        const auto index = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(corner);
        known_.push_back({mesh, index, corner.uv, corner.normal, heads_[corner.position]});
        heads_[corner.position] = static_cast<std::uint32_t>(known_.size() - 1);
        return index;
    }

    PlacedMesh place(GrowingMesh& source, const Matrix4d& placement) {
        PlacedMesh placed;
        Mesh& mesh = placed.mesh;
        mesh.name = part_.scene.objects[source.object].name;
        mesh.object = source.object;
        mesh.material = source.material;
        mesh.triangles = std::move(source.triangles);
        if (mirrors(placement))
            for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
        placed.positions.reserve(source.vertices.size());
        for (const auto& corner : source.vertices) {
            placed.positions.push_back(positions_[corner.position] * placement);
            if (source.hasUvs) mesh.uvs.push_back(uvs_[corner.uv]);
            if (source.coloured) mesh.uvs.push_back(colours_.uv(corner.uv));
            if (source.hasNormals) mesh.normals.push_back(normals_[corner.normal]);
        }
        if (!transformNormals(placement, mesh.normals)) {
            mesh.normals.clear();
            warnings_.add("normals " + mesh.name, fmt::format("'{}' has normals without length: it is shaded flat", mesh.name));
        }
        return placed;
    }

    const std::filesystem::path& path_;
    ScenePart& part_;
    WarningList& warnings_;
    obj::FileFinder files_;
    obj::MaterialLibrary library_;
    std::unordered_set<std::string> libraries_;  ///< paths that were read
    std::size_t line_ = 0;
    std::optional<Error> error_;

    obj::VertexColours colours_;
    std::unordered_map<std::string, std::uint32_t> colouredMaterials_;  ///< by usemtl's name
    std::vector<Vec3d> positions_;
    std::vector<Vec2> uvs_;
    std::vector<Vec3> normals_;

    std::string object_, material_;
    std::uint32_t mesh_ = kNone;  ///< the last face's, while object and material stay the same
    std::unordered_map<std::string, std::uint32_t> objects_;
    std::map<std::tuple<std::uint32_t, std::uint32_t, bool, bool>, std::uint32_t> meshIndices_;
    std::vector<GrowingMesh> meshes_;
    std::vector<std::uint32_t> heads_;  ///< by position, into known_
    std::vector<KnownVertex> known_;

    std::vector<Corner> corners_;  ///< of the face being read
    std::vector<Vec3d> polygon_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

Result<ScenePart> readObj(const std::filesystem::path& path, const GeometryPlacement& placement) {
    try {
        const auto bytes = readFile(path);
        if (!bytes) return bytes.error();
        if (bytes->find('\0') != std::string::npos)  // nothing in it would be an error: unknown lines are left out
            return Error{ErrorCode::Parse, "holds zero bytes, expected the text of an OBJ file", path.string()};
        ScenePart part;
        WarningList warnings;
        part.scene.name = path.stem().string();
        ObjReader reader(path, part, warnings);
        if (const auto result = reader.read(*bytes); !result) return result.error();
        reader.store(placementMatrix(placement, placement.yUp));
        if (!allFinite(part.scene))
            return Error{ErrorCode::Parse, "has coordinates beyond the range of floats once in metres", path.string()};
        if (part.scene.meshes.empty()) warnings.add("the file has no faces");
        for (const auto& text : warnings.texts()) part.scene.warnings.push_back(path.filename().string() + ": " + text);
        return part;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfResources, "memory ran out while reading", path.string()};
    } catch (const std::length_error&) {
        return Error{ErrorCode::OutOfResources, "memory ran out while reading", path.string()};
    }
}

}  // namespace luxdeck
