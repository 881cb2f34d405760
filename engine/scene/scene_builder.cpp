#include "engine/scene/scene_builder.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

namespace luxdeck {

namespace {

/// A scene written in code is right or a bug.
template <class T>
T must(Result<T> result) {
    if (!result) {
        std::fprintf(stderr, "scene written by hand: %s\n", result.error().text().c_str());
        std::abort();
    }
    return *std::move(result);
}

}  // namespace

std::uint32_t SceneBuilder::material(Material m) {
    scene_.materials.push_back(std::move(m));
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

std::uint32_t SceneBuilder::matte(float reflectance, const std::string& name) {
    Material m;
    m.name = name;
    m.reflectance = Rgb(reflectance);
    return material(m);
}

std::uint32_t SceneBuilder::glowing(float radianceCdM2, float reflectance) {
    Material m;
    m.name = "glowing";
    m.reflectance = Rgb(reflectance);
    m.emission = Rgb(radianceCdM2);
    return material(m);
}

SceneBuilder& SceneBuilder::mesh(Mesh mesh) {
    mesh.object = static_cast<std::uint32_t>(scene_.objects.size());
    scene_.objects.push_back({mesh.name, false});
    scene_.meshes.push_back(std::move(mesh));
    return *this;
}

SceneBuilder& SceneBuilder::quad(Vec3 origin, Vec3 u, Vec3 v, std::uint32_t material, int n) {
    Mesh m;
    m.name = "quad";
    m.material = material;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const float s = static_cast<float>(i) / static_cast<float>(n), t = static_cast<float>(j) / static_cast<float>(n);
            m.positions.push_back(origin + u * s + v * t);
            m.uvs.emplace_back(s, t);
        }
    const auto row = static_cast<std::uint32_t>(n + 1);
    for (std::uint32_t j = 0; j + 1 < row; ++j)
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = j * row + i;
            m.triangles.push_back({a, a + 1, a + row + 1});
            m.triangles.push_back({a, a + row + 1, a + row});
        }
    return mesh(std::move(m));
}

SceneBuilder& SceneBuilder::box(Vec3 low, Vec3 high, std::uint32_t material, bool inwards, int n) {
    const Vec3 d = high - low, x{d.x, 0, 0}, y{0, d.y, 0}, z{0, 0, d.z};
    const auto face = [&](Vec3 origin, Vec3 u, Vec3 v) { inwards ? quad(origin, v, u, material, n) : quad(origin, u, v, material, n); };
    face(low, y, x), face(low + z, x, y);  // bottom, top: outward normals
    face(low, x, z), face(low + y, z, x);
    face(low, z, y), face(low + x, y, z);
    return *this;
}

SceneBuilder& SceneBuilder::sphere(Vec3 centre, float radius, std::uint32_t material, bool inwards, int segments) {
    Mesh m;
    m.name = "sphere";
    m.material = material;
    const int rings = segments / 2;
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i <= segments; ++i) {
            const float theta = kPi * static_cast<float>(j) / static_cast<float>(rings);
            const float phi = 2 * kPi * static_cast<float>(i) / static_cast<float>(segments);
            m.positions.push_back(centre + Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)) * radius);
        }
    const auto row = static_cast<std::uint32_t>(segments + 1);
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rings); ++j)
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = j * row + i, b = a + row;
            for (auto t : {std::array<std::uint32_t, 3>{a, b, a + 1}, std::array<std::uint32_t, 3>{a + 1, b, b + 1}}) {
                if (inwards) std::swap(t[1], t[2]);
                m.triangles.push_back(t);
            }
        }
    return mesh(std::move(m));
}

SceneBuilder& SceneBuilder::luminaire(Vec3 position, CandelaTable table, LuminousOpening opening, Vec3 aim) {
    LuminaireType type;
    type.id = fmt::format("T{}", scene_.luminaireTypes.size() + 1);
    type.photometry.table = std::move(table);
    type.photometry.opening = opening;
    Luminaire l;
    l.name = type.id;
    l.type = static_cast<std::uint32_t>(scene_.luminaireTypes.size());
    l.position = position;
    l.frame = aim == Vec3(0, 0, -1) ? Frame{} : Frame::about(-aim.normalized());
    scene_.luminaireTypes.push_back(std::move(type));
    scene_.luminaires.push_back(l);
    return *this;
}

SceneBuilder& SceneBuilder::isotropic(Vec3 position, double lumens, LuminousOpening opening) {
    return luminaire(position, axialTable([&](double) { return lumens / (4 * kPiD); }), opening);
}

SceneBuilder& SceneBuilder::lambertian(Vec3 position, double candela0, LuminousOpening opening, Vec3 aim) {
    return luminaire(position, axialTable([&](double v) { return v < 90 ? candela0 * std::cos(v * kDegree) : 0.0; }), opening, aim);
}

SceneBuilder& SceneBuilder::texture(Texture texture) {
    scene_.textures.push_back(std::move(texture));
    return *this;
}

SceneBuilder& SceneBuilder::sky(Sky sky) {
    scene_.sky = sky;
    return *this;
}

Result<Scene> SceneBuilder::checked() {
    if (const auto ok = validate(scene_); !ok) return ok.error();
    return std::move(scene_);
}

Scene SceneBuilder::build() { return must(checked()); }

CandelaTable axialTable(const std::function<double(double)>& candela) {
    std::vector<double> vertical, values;
    for (int v = 0; v <= 180; ++v) {
        vertical.push_back(v);
        values.push_back(candela(v));
    }
    return must(CandelaTable::create(PhotometryType::C, vertical, {0.0}, values));
}

}  // namespace luxdeck
