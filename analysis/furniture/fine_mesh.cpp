#include "analysis/furniture/fine_mesh.h"

#include "engine/core/rng.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace luxdeck {

namespace {

constexpr std::size_t kMostVertices = 20'000'000;
constexpr float kUp = 0.9659F;        // cos 15 degrees
constexpr double kBandM = 0.05;
constexpr int kMostPieces = 2048;     // along an edge

/// What the surface returns diffusely, for the light between parts of an object.
Rgb diffuseOf(const Material& m) { return m.kind == MaterialKind::Metal || m.kind == MaterialKind::Mirror ? m.specular : m.reflectance; }

Vec3 crossOf(const MovableObject& o, const std::array<std::uint32_t, 3>& t) {
    return cross(o.positions[t[1]] - o.positions[t[0]], o.positions[t[2]] - o.positions[t[0]]);
}

}  // namespace

std::size_t FineMesh::KeyHash::operator()(const Key& key) const {
    std::uint64_t h = 0;
    for (const float x : key) h = mix64(h ^ std::bit_cast<std::uint32_t>(x + 0.0F));
    return h;
}

std::uint32_t FineMesh::vertex(const Corner& corner, const Rgb& reflectance) {
    const Vec3 &p = corner.position, n = corner.normal.normalized();
    const auto [found, isNew] = index_.try_emplace(Key{p.x, p.y, p.z, n.x, n.y, n.z}, static_cast<std::uint32_t>(object_.positions.size()));
    if (isNew) object_.positions.push_back(p), object_.normals.push_back(n), object_.reflectance.push_back(reflectance);
    return found->second;
}

/// n x n pieces: n rows of vertices, each one longer than the row before.
void FineMesh::divide(const std::array<Corner, 3>& corners, int n, const Rgb& reflectance, bool solid) {
    const auto at = [&](int row, int column) {
        const float b = static_cast<float>(row - column) / static_cast<float>(n), c = static_cast<float>(column) / static_cast<float>(n);
        const float a = static_cast<float>(n - row) / static_cast<float>(n);
        return Corner{corners[0].position * a + corners[1].position * b + corners[2].position * c,
                      corners[0].normal * a + corners[1].normal * b + corners[2].normal * c};
    };
    const auto index = [](int row, int column) { return static_cast<std::size_t>(row * (row + 1) / 2 + column); };
    rows_.clear();
    for (int row = 0; row <= n; ++row)
        for (int column = 0; column <= row; ++column) rows_.push_back(vertex(at(row, column), reflectance));
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        object_.triangles.push_back({a, b, c}), object_.solid.push_back(solid ? 1 : 0);
    };
    for (int row = 0; row < n; ++row)
        for (int column = 0; column <= row; ++column) {
            add(rows_[index(row, column)], rows_[index(row + 1, column)], rows_[index(row + 1, column + 1)]);
            if (column < row) add(rows_[index(row, column)], rows_[index(row + 1, column + 1)], rows_[index(row, column + 1)]);
        }
}

Result<void> FineMesh::add(const Scene& scene, const Mesh& mesh) {
    index_.clear();
    const auto& material = scene.materials[mesh.material];
    const bool solid = !scene.letsStraightThrough(material);
    const Rgb reflectance = diffuseOf(material);
    const Vec3 pivot(object_.pivot);
    for (const auto& t : mesh.triangles) {
        std::array<Corner, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i].position = mesh.positions[t[i]] - pivot;
        const Vec3 normal = cross(corners[1].position - corners[0].position, corners[2].position - corners[0].position);
        if (!(normal.length2() > 0)) continue;
        float longest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i].normal = mesh.normals.empty() ? normal.normalized() : mesh.normals[t[i]];
            longest = std::max(longest, (corners[i].position - corners[(i + 1) % 3].position).length());
        }
        const int n = std::clamp(static_cast<int>(std::ceil(longest / longestEdgeM_ - 1e-4)), 1, kMostPieces);
        if (object_.positions.size() + static_cast<std::size_t>(n + 1) * static_cast<std::size_t>(n + 2) / 2 > kMostVertices)
            return Error{ErrorCode::OutOfResources, fmt::format("\"{}\" would have more than {} vertices: stream it instead, or take a longer edge", object_.name, kMostVertices), {}};
        divide(corners, n, reflectance, solid);
    }
    return {};
}

void findWorkingSurface(MovableObject& object) {
    object.workingAreaM2.assign(object.positions.size(), 0);
    object.workingSurfaceM2 = 0;
    std::map<int, double> bands;  // area by height
    const auto bandOf = [&](const std::array<std::uint32_t, 3>& t) {
        const float z = (object.positions[t[0]].z + object.positions[t[1]].z + object.positions[t[2]].z) / 3;
        return static_cast<int>(std::floor(z / kBandM));
    };
    const auto facesUp = [](const Vec3& normal) { return normal.z > kUp * normal.length(); };
    for (const auto& t : object.triangles)
        if (const Vec3 n = crossOf(object, t); facesUp(n)) bands[bandOf(t)] += 0.5 * n.length();
    double fullest = 0;
    for (const auto& [band, area] : bands) fullest = std::max(fullest, area);
    int highest = 0;
    for (const auto& [band, area] : bands)
        if (area >= fullest / 2) highest = band;
    if (!(fullest > 0)) return;
    for (const auto& t : object.triangles) {
        const Vec3 n = crossOf(object, t);
        if (!facesUp(n) || bandOf(t) != highest) continue;
        for (const auto v : t) object.workingAreaM2[v] += n.length() / 6;
        object.workingSurfaceM2 += 0.5 * n.length();
    }
}

}  // namespace luxdeck
