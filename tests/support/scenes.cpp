#include "tests/support/scenes.h"

#include "engine/algorithms/registry.h"
#include "engine/transport/sky_visibility.h"

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
