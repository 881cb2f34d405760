#include "tests/support/scenes.h"

#include "engine/transport/sky_visibility.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace luxdeck::test {

namespace {

[[noreturn]] void fail(const std::string& message) {
    std::fprintf(stderr, "test scene: %s\n", message.c_str());
    std::abort();
}

template <class T>
T must(Result<T> result) {
    if (!result) fail(result.error().text());
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
    type.id = "T" + std::to_string(scene_.luminaireTypes.size() + 1);
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

Scene SceneBuilder::build() {
    if (const auto ok = validate(scene_); !ok) fail(ok.error().text());
    return std::move(scene_);
}

CandelaTable axialTable(const std::function<double(double)>& candela) {
    std::vector<double> vertical, values;
    for (int v = 0; v <= 180; ++v) {
        vertical.push_back(v);
        values.push_back(candela(v));
    }
    return must(CandelaTable::create(PhotometryType::C, vertical, {0.0}, values));
}

Scene cubeRoom(float rho, double lumens) {
    SceneBuilder b;
    b.box({0, 0, 0}, {4, 4, 4}, b.matte(rho), true, 4);
    b.isotropic({2, 2, 2}, lumens);
    return b.build();
}

Scene furnishedRoom() {
    SceneBuilder b;
    Material red, metal, glass;
    red.name = "red", red.reflectance = {0.6F, 0.2F, 0.15F};
    metal.name = "metal", metal.kind = MaterialKind::Metal, metal.specular = {0.8F, 0.75F, 0.6F}, metal.roughness = 0.35F;
    glass.name = "glass", glass.kind = MaterialKind::ThinGlass, glass.transmittance = Rgb(0.85F);
    b.box({0, 0, 0}, {6, 4, 2.8F}, b.matte(0.65F), true, 8);
    b.quad({0.01F, 0, 0}, {0, 4, 0}, {0, 0, 2.8F}, b.material(red));
    b.box({2, 1, 0.7F}, {4, 2, 0.74F}, b.matte(0.4F), false);
    b.box({4.5F, 2.5F, 0}, {5.2F, 3.2F, 1}, b.material(metal), false);
    b.quad({3, 2.2F, 0}, {0, 1.7F, 0}, {0, 0, 2.2F}, b.material(glass));
    const LuminousOpening panel{OpeningShape::Rectangle, 0.6, 0.6, 0};
    b.lambertian({1.5F, 2, 2.79F}, 900, panel).lambertian({3, 2, 2.79F}, 900, panel).lambertian({4.5F, 2, 2.79F}, 900, panel);
    return b.build();
}

Scene richRoom() {
    SceneBuilder b;
    Material mirror, glass, plastic, textured, lamp;
    mirror.name = "mirror", mirror.kind = MaterialKind::Mirror, mirror.specular = Rgb(0.9F);
    glass.name = "glass", glass.kind = MaterialKind::ThinGlass, glass.transmittance = {0.8F, 0.86F, 0.82F};
    plastic.name = "plastic", plastic.kind = MaterialKind::Plastic, plastic.reflectance = {0.2F, 0.3F, 0.6F};
    textured.name = "textured", textured.reflectance = Rgb(0.8F), textured.reflectanceTexture.texture = 0;
    lamp.name = "lamp", lamp.reflectance = Rgb(0.3F), lamp.emission = {900, 1000, 700};
    const auto white = b.matte(0.7F);
    b.quad({0, 0, 0}, {4, 0, 0}, {0, 3, 0}, b.material(textured));              // floor
    b.quad({0, 0, 2.5F}, {0, 3, 0}, {4, 0, 0}, white);                          // ceiling
    b.quad({0, 0, 0}, {0, 3, 0}, {0, 0, 2.5F}, white);                          // x = 0
    b.quad({0, 0, 0}, {0, 0, 2.5F}, {4, 0, 0}, white);                          // y = 0
    b.quad({0, 3, 0}, {4, 0, 0}, {0, 0, 1}, white);                             // y = 3 below the window
    b.quad({0.5F, 3, 1}, {3, 0, 0}, {0, 0, 1.5F}, b.material(glass));
    b.quad({4, 0, 0}, {0, 0, 2.5F}, {0, 3, 0}, b.material(mirror));             // x = 4
    b.quad({1, 1, 2.3F}, {0, 0.5F, 0}, {0.5F, 0, 0}, b.material(lamp));
    b.sphere({2.5F, 1.2F, 0.5F}, 0.4F, b.material(plastic), false, 24);
    b.isotropic({3, 2, 2}, 1500, {OpeningShape::Sphere, 0.2, 0.2, 0.2});
    b.sky({SkyKind::CieOvercast, 3000, 0.2, Rgb(1.0F)});
    Texture checks;
    checks.name = "checks", checks.width = checks.height = 2;
    checks.rgba = {200, 180, 160, 255, 90, 80, 70, 255, 90, 80, 70, 255, 200, 180, 160, 255};
    b.texture(checks);
    return b.build();
}

Lit::Lit(Scene s, bool bruteForce) : scene(std::move(s)), needs(SceneNeeds::of(scene)) {
    raycaster = bruteForce ? makeBruteForceRaycaster(scene) : must(makeEmbreeRaycaster(scene));
    lights = std::make_unique<LightSampler>(scene, needs);
    mirrors = std::make_unique<Mirrors>(scene, needs);
    sky = makeSkySampler(scene, needs, *raycaster);
}

Lit::Lit(Scene s, SceneNeeds forced) : scene(std::move(s)), needs(forced) {
    raycaster = must(makeEmbreeRaycaster(scene));
    lights = std::make_unique<LightSampler>(scene, needs);
    mirrors = std::make_unique<Mirrors>(scene, needs);
    sky = makeSkySampler(scene, needs, *raycaster);
}

std::unique_ptr<RadianceEstimator> Lit::estimator(const std::string& algorithm, const AlgorithmSettings& settings) const {
    return must(makeEstimator(algorithm, transport(), settings));
}

}  // namespace luxdeck::test
