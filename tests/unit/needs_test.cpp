#include "engine/scene/needs.h"

#include "engine/algorithms/registry.h"
#include "engine/io/project.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>

namespace luxdeck::test {
namespace {

SceneNeeds nothing() {
    return {false, false, false, false, false, false, false, false, false, false, false, false, false, false, false};
}

bool operator==(const SceneNeeds& a, const SceneNeeds& b) {
    const auto bits = [](const SceneNeeds& n) {
        return std::array{n.specularChains, n.transmission, n.glossy, n.textures, n.smoothNormals, n.sky,
                          n.meshLights, n.luminaireSurfaces, n.manyLights, n.colour, n.rebasing,
                          n.scatteredTransmission, n.dielectrics, n.alpha, n.patterns};
    };
    return bits(a) == bits(b);
}

/// What a plain grey room needs after one change, of its one material or of the scene.
SceneNeeds needsAfter(const std::function<void(Scene&)>& change) {
    Scene scene = cubeRoom(0.5F, 1000);
    change(scene);
    return SceneNeeds::of(scene);
}

TEST(SceneNeeds, APlainGreyRoomNeedsNothing) {
    EXPECT_TRUE(needsAfter([](Scene&) {}) == nothing());
    EXPECT_EQ(leftOut(nothing()).size(), 15U);
    EXPECT_TRUE(leftOut(SceneNeeds::everything()).empty());
    for (const auto& line : leftOut(nothing())) EXPECT_FALSE(line.what.empty() || line.why.empty());
    EXPECT_TRUE(SceneNeeds::of(Scene{}) == nothing());
}

TEST(SceneNeeds, EachFeatureIsSeen) {
    const auto check = [](const std::function<void(Scene&)>& change, const std::function<void(SceneNeeds&)>& expected, const char* what) {
        SceneNeeds needs = nothing();
        expected(needs);
        EXPECT_TRUE(needsAfter(change) == needs) << what;
    };
    check([](Scene& s) { s.materials[0].kind = MaterialKind::Mirror; }, [](SceneNeeds& n) { n.specularChains = n.glossy = true; }, "mirror");
    check([](Scene& s) { s.materials[0].kind = MaterialKind::ThinGlass; }, [](SceneNeeds& n) { n.specularChains = n.glossy = n.transmission = true; }, "glass");
    check([](Scene& s) { s.materials[0].kind = MaterialKind::Plastic; }, [](SceneNeeds& n) { n.glossy = true; }, "plastic");
    check([](Scene& s) { s.materials[0].reflectanceTexture.texture = 0; }, [](SceneNeeds& n) { n.textures = n.colour = true; }, "texture");
    check([](Scene& s) { s.meshes[0].normals.resize(s.meshes[0].positions.size()); }, [](SceneNeeds& n) { n.smoothNormals = true; }, "normals");
    check([](Scene& s) { s.sky = {SkyKind::Uniform, 100, 0.2, Rgb(1.0F)}; }, [](SceneNeeds& n) { n.sky = true; }, "sky");
    check([](Scene& s) { s.sky = {SkyKind::Uniform, 0, 0.2, {1, 0.9F, 0.8F}}; }, [](SceneNeeds&) {}, "a black sky");
    check([](Scene& s) { s.sky = {SkyKind::Uniform, 100, 0.2, {1, 0.9F, 0.8F}}; }, [](SceneNeeds& n) { n.sky = n.colour = true; }, "coloured sky");
    check([](Scene& s) { s.materials[0].emission = Rgb(1.0F); }, [](SceneNeeds& n) { n.meshLights = true; }, "emission");
    check([](Scene& s) { s.materials[0].reflectance.r = 0.6F; }, [](SceneNeeds& n) { n.colour = true; }, "colour");
    check([](Scene& s) { s.luminaireTypes[0].colour.r = 0.6F; }, [](SceneNeeds& n) { n.colour = true; }, "coloured lamp");
    check([](Scene& s) { s.luminaireTypes[0].photometry.opening = {OpeningShape::Disc, 1, 1, 0}; }, [](SceneNeeds& n) { n.luminaireSurfaces = true; }, "opening");
    check([](Scene& s) { s.luminaires.resize(kManyLights, s.luminaires[0]); }, [](SceneNeeds&) {}, "just few enough luminaires");
    check([](Scene& s) { s.luminaires.resize(kManyLights + 1, s.luminaires[0]); }, [](SceneNeeds& n) { n.manyLights = true; }, "many luminaires");
    check([](Scene& s) { s.origin.x = 1e6; }, [](SceneNeeds& n) { n.rebasing = true; }, "far away");
    check([](Scene& s) { s.materials[0].kind = MaterialKind::Ward, s.materials[0].wardU = s.materials[0].wardV = 0.1F; }, [](SceneNeeds& n) { n.glossy = true; }, "a Ward lobe");
    check([](Scene& s) { s.materials[0].kind = MaterialKind::Ward; }, [](SceneNeeds& n) { n.glossy = n.specularChains = true; }, "a Ward surface with a perfect gloss");
    check([](Scene& s) { s.materials[0].kind = MaterialKind::Ward, s.materials[0].specular = Rgb(0.0F), s.materials[0].diffuseTransmittance = Rgb(0.2F); },
          [](SceneNeeds& n) { n.glossy = n.scatteredTransmission = true; }, "light scattered through");
    check([](Scene& s) { s.materials[0].kind = MaterialKind::Ward, s.materials[0].specularTransmittance = Rgb(0.2F); },
          [](SceneNeeds& n) { n.glossy = n.specularChains = n.transmission = true; }, "light straight through");
    check([](Scene& s) { s.materials[0].kind = MaterialKind::Dielectric; }, [](SceneNeeds& n) { n.glossy = n.specularChains = n.dielectrics = true; }, "solid");
    check([](Scene& s) { s.materials[0].alphaBlend = true; }, [](SceneNeeds& n) { n.alpha = n.transmission = true; }, "holes");
    check([](Scene& s) { s.materials[0].reflectancePattern = 0; }, [](SceneNeeds& n) { n.patterns = n.colour = true; }, "pattern");
    check([](Scene& s) {
              s.materials[0].kind = MaterialKind::Mix;
              s.materials[0].mixFirst = s.materials[0].mixSecond = static_cast<std::uint32_t>(s.materials.size());
              s.materials.push_back({}), s.materials.back().kind = MaterialKind::ThinGlass;
          },
          [](SceneNeeds& n) { n.patterns = n.colour = n.glossy = n.specularChains = n.transmission = true; }, "a mixture with a pane");
    check([](Scene& s) { s.materials.push_back({}), s.materials.back().kind = MaterialKind::Mirror; }, [](SceneNeeds&) {}, "a mirror that no mesh uses");
}

// Leaving a stage out never changes a result. The streams of random numbers differ (a lobe is chosen only where there
// is more than one), so the comparison is statistical: |z| < 4 on 31 + 31 degrees of freedom, where Student's t
// exceeds 4 in 2e-4 of all cases; seeds are fixed.
struct Case {
    std::string name;
    std::function<std::optional<Scene>()> scene;
    std::vector<Vec3d> points;  // user coordinates
};

std::optional<Scene> office() {
    auto project = loadProject(std::filesystem::path(LUXDECK_SOURCE_DIR) / "projects/office/project.toml");
    EXPECT_TRUE(project) << project.error().text();
    if (!project) return std::nullopt;
    return std::move(project->scene);
}

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class LeavingOut : public testing::TestWithParam<std::tuple<Case, Algorithm>> {};

/// Float rounding; and where something was prepared, by other random numbers on either side, twice the bias that the
/// algorithm states, and half a lux (cd/m^2) of what leaks into the desk that one of the office's points lies in.
double slack(const Algorithm& algorithm, double value) { return 1e-5 * value + (algorithm.bias > 0 ? 2 * algorithm.bias * value + 0.5 : 0.0); }

TEST_P(LeavingOut, NeverChangesAResult) {
    const auto& [c, algorithm] = GetParam();
    const auto scene = c.scene();
    ASSERT_TRUE(scene);
    const Lit lean(*scene), full(*scene, SceneNeeds::everything());
    const AlgorithmSettings settings{.ambientLux = algorithm.name == "ambient" ? 50.0 : 0.0};
    const auto few = lean.estimator(algorithm.name, settings), all = full.estimator(algorithm.name, settings);
    for (std::size_t i = 0; i < c.points.size(); ++i) {
        Target sensor, eye;
        sensor.sensor = facing(scene->toRebased(c.points[i]), {0.1F, 0.2F, 1});
        eye.radiance = true, eye.ray = {sensor.sensor.position, 0, Vec3(0.8F, 0.5F, -0.3F).normalized(), kInfinity};
        for (const auto& target : {sensor, eye}) {
            TransportCounters counters;
            const auto a = measure(*few, scene->weights, target, 1, 0, 64, counters), b = measure(*all, scene->weights, target, 2, 0, 64, counters);
            for (const auto& [x, y] : {std::pair{a.directMeans(), b.directMeans()}, std::pair{a.indirectMeans(), b.indirectMeans()}}) {
                MeanVariance mx, my;
                for (const double v : x) mx.add(v);
                for (const double v : y) my.add(v);
                const double error = std::sqrt(mx.meanVariance() + my.meanVariance());
                EXPECT_NEAR(mx.mean(), my.mean(), 4 * error + slack(algorithm, mx.mean())) << "point " << i << (target.radiance ? " radiance" : " illuminance");
            }
            EXPECT_EQ(counters.rejected, 0U);
        }
    }
}

std::vector<Case> cases() {
    return {{"cube", [] { return std::optional(cubeRoom(0.6F, 10000)); }, {{1, 1.2, 0.8}, {3, 2.2, 2}}},
            {"furnished", [] { return std::optional(furnishedRoom()); }, {{1, 3, 0.8}, {4, 3, 0.3}}},
            {"rich", [] { return std::optional(richRoom()); }, {{1, 2, 0.3}, {3.2, 2.5, 1}}},
            {"office", office, {{2, 2, 0.75}, {4, 3, 1.2}}}};
}

INSTANTIATE_TEST_SUITE_P(All, LeavingOut, testing::Combine(testing::ValuesIn(cases()), testing::ValuesIn(algorithms())),
                         [](const auto& p) { return std::get<0>(p.param).name + "_by_" + std::get<1>(p.param).name; });

// Where no random number is left out either, the results are the same but for rounding.
TEST(LeavingOutExactly, WhatDrawsNoNumbers) {
    const Scene scene = furnishedRoom();
    SceneNeeds more = SceneNeeds::of(scene);
    ASSERT_TRUE(more.glossy && more.colour);
    more.textures = more.smoothNormals = more.sky = more.meshLights = more.rebasing = true;
    const Lit lean(scene), full(scene, more);
    for (const auto& algorithm : algorithms()) {
        Target target;
        target.sensor = facing({1, 3, 0.8F}, {0.1F, 0.2F, 1});
        TransportCounters counters;
        const auto a = measure(*lean.estimator(algorithm.name), scene.weights, target, 1, 0, 32, counters).totalMeans();
        const auto b = measure(*full.estimator(algorithm.name), scene.weights, target, 1, 0, 32, counters).totalMeans();
        for (std::size_t r = 0; r < kReplicates; ++r) EXPECT_NEAR(a[r], b[r], 1e-5 * a[r]) << algorithm.name;  // float rounding
    }
}

}  // namespace
}  // namespace luxdeck::test
