#include "engine/io/gltf_mesh.h"

#include "engine/io/gltf_accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace luxdeck::gltf {

namespace {

enum Mode : std::uint64_t { kTriangles = 4, kStrip = 5, kFan = 6 };

bool isSurface(const JsonView& primitive) { return primitive["mode"].count(kTriangles) >= kTriangles; }

/// The accessor of an attribute, checked to have the wanted shape; none when absent.
std::optional<std::size_t> attribute(Document& document, const JsonView& attributes, const char* name, int components,
                                     std::optional<std::uint64_t> count) {
    const auto json = attributes[name];
    const auto index = json.index(document.accessors().size(), "accessors", false);
    if (index < 0) return std::nullopt;
    const Accessor& accessor = document.accessors()[static_cast<std::size_t>(index)];
    if (accessor.components != components) {
        json.fail(fmt::format("accessors[{}] is not VEC{}", index, components));
        return std::nullopt;
    }
    if (count && accessor.count != *count) {
        json.fail(fmt::format("accessors[{}] has {} elements, expected {} as in POSITION", index, accessor.count, *count));
        return std::nullopt;
    }
    return static_cast<std::size_t>(index);
}

std::vector<Vec3> vectors(const std::vector<float>& numbers) {
    std::vector<Vec3> result(numbers.size() / 3);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    return result;
}

/// Triangles of a strip or fan that repeat a corner are there to turn corners, and cover nothing.
void addUnlessFolded(std::vector<std::array<std::uint32_t, 3>>& triangles, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) triangles.push_back({a, b, c});
}

/// Source: glTF 2.0, 3.7.2.1 "Meshes: overview", the formulas of triangle topology.
std::vector<std::array<std::uint32_t, 3>> assemble(std::uint64_t mode, const std::vector<std::uint32_t>& corners) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const std::size_t n = corners.size();
    if (mode == kTriangles) {
        triangles.reserve(n / 3);
        for (std::size_t i = 0; i + 2 < n; i += 3) triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    } else {
        for (std::size_t i = 0; i + 2 < n; ++i) {
            if (mode == kStrip)
                addUnlessFolded(triangles, corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]);
            else
                addUnlessFolded(triangles, corners[i + 1], corners[i + 2], corners[0]);
        }
    }
    return triangles;
}

/// Renumbers the corners to count used vertices alone, and returns those, ascending: many primitives may
/// share one large vertex array, and each takes along only what it uses.
std::vector<std::uint32_t> compact(std::vector<std::uint32_t>& corners, std::uint64_t vertexCount) {
    std::vector<std::uint32_t> used;
    if (vertexCount <= 4 * corners.size()) {
        std::vector<std::uint32_t> number(vertexCount, 0);
        for (const auto corner : corners) number[corner] = 1;
        for (std::uint32_t vertex = 0; vertex < vertexCount; ++vertex) {
            if (number[vertex] == 0) continue;
            number[vertex] = static_cast<std::uint32_t>(used.size());
            used.push_back(vertex);
        }
        for (auto& corner : corners) corner = number[corner];
        return used;
    }
    used = corners;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (auto& corner : corners)
        corner = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), corner) - used.begin());
    return used;
}

void readUvs(Document& document, const JsonView& attributes, int uvSet, std::uint64_t count,
             const std::vector<std::uint32_t>& used, Primitive& primitive) {
    const std::string name = fmt::format("TEXCOORD_{}", uvSet);
    const auto accessor = attribute(document, attributes, name.c_str(), 2, count);
    if (!accessor) {
        if (!document.failure.failed())
            document.warnings.add("uv", fmt::format("{} has no {}: its textures are left out", attributes.path(), name));
        return;
    }
    const auto numbers = readNumbers(document, *accessor, used);
    if (!std::all_of(numbers.begin(), numbers.end(), [](float x) { return std::isfinite(x); })) {
        document.warnings.add("uv", fmt::format("{}.{} is not finite: textures are left out", attributes.path(), name));
        return;
    }
    primitive.uvs.resize(used.size());
    for (std::size_t i = 0; i < used.size(); ++i) primitive.uvs[i] = {numbers[2 * i], numbers[2 * i + 1]};
}

void checkFinite(const JsonView& attributes, const std::string& meshName, const std::vector<std::uint32_t>& used,
                 const std::vector<Vec3>& positions) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vec3& p = positions[i];
        if (isFinite(p)) continue;
        attributes["POSITION"].fail(fmt::format("vertex {} of mesh '{}' is ({}, {}, {}), expected finite numbers", used[i],
                                                meshName, p.x, p.y, p.z));
        return;
    }
}

std::vector<std::uint32_t> readCorners(Document& document, const JsonView& json, std::uint64_t mode, std::uint64_t vertices) {
    const auto accessor = json["indices"].index(document.accessors().size(), "accessors", false);
    std::vector<std::uint32_t> corners;
    if (document.failure.failed()) return corners;
    if (accessor >= 0) {
        corners = readIndices(document, static_cast<std::size_t>(accessor), vertices, json);
    } else {
        corners.resize(vertices);
        std::iota(corners.begin(), corners.end(), 0U);
    }
    if (mode == kTriangles && corners.size() % 3 != 0)
        json.fail(fmt::format("has {} corners, expected a multiple of 3 for triangles", corners.size()));
    return corners;
}

void warnOfLeftOut(Document& document, const JsonView& json, const JsonView& attributes) {
    if (json["targets"].size() > 0) document.warnings.add("morph", "morph targets are left out: meshes keep their base shape");
    if (attributes["COLOR_1"].present()) document.warnings.add("colour 1", "COLOR_1 has no meaning in glTF: left out");
}

/// Each triangle gets vertices of its own, so that it can have a colour of its own.
void separateTriangles(Primitive& primitive) {
    Primitive apart;
    for (const auto& triangle : primitive.triangles) {
        const auto first = static_cast<std::uint32_t>(apart.positions.size());
        for (const auto corner : triangle) {
            apart.positions.push_back(primitive.positions[corner]);
            if (!primitive.normals.empty()) apart.normals.push_back(primitive.normals[corner]);
        }
        apart.triangles.push_back({first, first + 1, first + 2});
    }
    primitive.positions = std::move(apart.positions);
    primitive.normals = std::move(apart.normals);
    primitive.triangles = std::move(apart.triangles);
}

/// COLOR_0 multiplies the base colour. Linear, floats or normalised integers; its alpha is left out.
void readColours(Document& document, const JsonView& attributes, std::int64_t material,
                 const std::vector<std::uint32_t>& used, MaterialReader& materials, Primitive& primitive) {
    const auto json = attributes["COLOR_0"];
    const auto index = json.index(document.accessors().size(), "accessors", false);
    if (index < 0 || primitive.triangles.empty()) return;
    const Accessor& accessor = document.accessors()[static_cast<std::size_t>(index)];
    if (accessor.components < 3 || accessor.components > 4 || accessor.count <= used.back())
        return json.fail(fmt::format("accessors[{}] is not VEC3 or VEC4 with an element for each vertex", index));
    const auto numbers = readNumbers(document, static_cast<std::size_t>(index), used);
    const auto width = static_cast<std::size_t>(accessor.components);
    if (!std::all_of(numbers.begin(), numbers.end(), [](float x) { return std::isfinite(x); }))
        return document.warnings.add("colour", "vertex colours that are not finite are left out");
    obj::VertexColours colours;
    for (std::size_t i = used.size(); i-- > 0;)  // from the last: the list grows once
        colours.add(i, {numbers[width * i], numbers[width * i + 1], numbers[width * i + 2]});
    std::vector<std::uint32_t> faces;
    for (const auto& t : primitive.triangles) faces.push_back(colours.face({t[0], t[1], t[2]}));
    const auto made = materials.coloured(material, colours);
    if (!made)
        return document.warnings.add("colour", "vertex colours are left out beside a texture, and on glass");
    primitive.material = *made;
    separateTriangles(primitive);
    for (const auto face : faces) primitive.uvs.insert(primitive.uvs.end(), 3, colours.uv(face));
}

Primitive readPrimitive(Document& document, const JsonView& json, const std::string& meshName, MaterialReader& materials) {
    Primitive primitive;
    const auto attributes = json["attributes"];
    const std::uint64_t mode = json["mode"].count(kTriangles);
    if (mode > kFan) json["mode"].fail(fmt::format("is {}, expected 0 .. 6", mode));
    const auto material = json["material"].index(document.root()["materials"].size(), "materials", false);
    const auto position = attribute(document, attributes, "POSITION", 3, std::nullopt);
    if (document.failure.failed()) return primitive;
    if (!position) {
        document.warnings.add("position", fmt::format("{} has no POSITION: it is left out", json.path()));
        return primitive;
    }
    const std::uint64_t count = document.accessors()[*position].count;
    const auto normal = attribute(document, attributes, "NORMAL", 3, count);
    auto corners = readCorners(document, json, mode, count);
    if (document.failure.failed()) return primitive;

    const auto used = compact(corners, count);
    primitive.triangles = assemble(mode, corners);
    primitive.positions = vectors(readNumbers(document, *position, used));
    checkFinite(attributes, meshName, used, primitive.positions);
    if (normal) primitive.normals = vectors(readNumbers(document, *normal, used));
    const bool bare = material < 0 && attributes["COLOR_0"].present();  // its colours are all that is known of it
    if (!bare) {
        const MaterialUse use = materials.use(material);
        primitive.material = use.material;
        if (use.uvSet >= 0) readUvs(document, attributes, use.uvSet, count, used, primitive);
    }
    const auto plain = bare ? -1 : static_cast<std::int64_t>(primitive.material);
    if (primitive.uvs.empty()) readColours(document, attributes, plain, used, materials, primitive);
    if (bare && primitive.uvs.empty()) primitive.material = materials.use(-1).material;
    warnOfLeftOut(document, json, attributes);
    return primitive;
}

}  // namespace

void Primitive::turnRound() {
    for (auto& triangle : triangles) std::swap(triangle[1], triangle[2]);
    for (auto& normal : normals) normal = -normal;
}

MeshSize meshSize(Document& document, const JsonView& mesh) {
    MeshSize size;
    const auto list = mesh["primitives"];
    const auto& accessors = document.accessors();
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto primitive = list.at(i);
        if (!isSurface(primitive)) continue;
        const auto position = primitive["attributes"]["POSITION"].index(accessors.size(), "accessors", false);
        const auto indices = primitive["indices"].index(accessors.size(), "accessors", false);
        if (position < 0) continue;
        const std::uint64_t vertices = accessors[static_cast<std::size_t>(position)].count;
        const std::uint64_t corners = indices < 0 ? vertices : accessors[static_cast<std::size_t>(indices)].count;
        const bool strip = primitive["mode"].count(kTriangles) != kTriangles;
        const bool coloured = primitive["attributes"]["COLOR_0"].present();  // three vertices for each triangle then
        size.vertices += coloured ? corners : std::min(vertices, corners);
        size.triangles += strip ? corners : corners / 3;
    }
    return size;
}

std::vector<Primitive> readMesh(Document& document, const JsonView& mesh, MaterialReader& materials) {
    std::vector<Primitive> primitives;
    const auto list = mesh["primitives"];
    const std::string name = mesh["name"].text(mesh.path());
    if (!list.present()) list.fail("is missing, expected an array");
    for (std::size_t i = 0; i < list.size() && !document.failure.failed(); ++i) {
        if (!isSurface(list.at(i))) {
            document.warnings.add("lines", fmt::format("{} is points or lines, which have no surface: left out", list.at(i).path()));
            continue;
        }
        auto primitive = readPrimitive(document, list.at(i), name, materials);
        if (!primitive.triangles.empty()) primitives.push_back(std::move(primitive));
    }
    return primitives;
}

}  // namespace luxdeck::gltf
