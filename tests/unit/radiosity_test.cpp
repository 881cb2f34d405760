// The mesh of radiosity, its balance of light, and where it leaks.
#include "engine/transport/radiosity/radiosity_field.h"

#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace luxdeck::test {
namespace {

std::unique_ptr<RadiosityField> fieldOf(const Lit& lit, double effort = 1, std::uint64_t seed = 1) {
    AlgorithmSettings settings;
    settings.effort = effort, settings.seed = seed;
    auto field = RadiosityField::create(lit.transport(), settings);
    EXPECT_TRUE(field) << field.error().text();
    return *std::move(field);
}

/// Area of all matte surfaces that reflect, one side.
double areaOf(const Scene& scene) {
    double sum = 0;
    for (const auto& mesh : scene.meshes) {
        const auto& m = scene.materials[mesh.material];
        if (m.kind != MaterialKind::Matte || m.reflectance.isBlack()) continue;
        for (const auto& t : mesh.triangles)
            sum += Vec3d(mesh.positions[t[1]] - mesh.positions[t[0]]).cross(Vec3d(mesh.positions[t[2]] - mesh.positions[t[0]])).length() / 2;
    }
    return sum;
}

// Invariants: elements cover all once; a point taken of one is found in it; small triangles are joined, large ones cut.
TEST(SurfaceElements, CoverAllMatteSurfacesOnce) {
    SceneBuilder b;
    const auto matte = b.matte(0.5F);
    b.box({0, 0, 0}, {4, 4, 4}, matte, true).sphere({2, 2, 2}, 0.2F, matte, false, 64).quad({1, 1, 1}, {3, 0, 0}, {0, 0.01F, 0}, matte);
    b.quad({-50, -50, -1}, {100, 0, 0}, {0, 100, 0}, b.matte(0.2F)).quad({1, 1, 2}, {1, 0, 0}, {0, 1, 0}, b.matte(0));
    const auto scene = b.build();
    const auto needs = SceneNeeds::of(scene);
    const SurfaceElements elements(scene, needs, 1000);
    EXPECT_GT(elements.size(), 2U * 500);
    EXPECT_LT(elements.size(), 2U * 2000);
    double sum = 0;
    for (std::size_t e = 0; e < elements.size(); ++e) sum += elements.areaM2(e) / 2;
    EXPECT_NEAR(sum, areaOf(scene), 1e-5 * areaOf(scene));
    EXPECT_EQ(elements.at(static_cast<std::uint32_t>(scene.meshes.size() - 1), 0, 0.3F, 0.3F, true), SurfaceElements::kNone) << "black";
    for (std::size_t e = 0; e < elements.size(); ++e)
        for (std::uint32_t i = 0; i < 4; ++i) {
            const auto at = elements.place(e, SamplePath(e, i).next2D());
            EXPECT_EQ(at.frontFace, e % 2 == 0);
        }
}

// The same by rays: what a ray meets at an element's point is in that element. On the edges of its parts rounding may
// decide either way: one in a thousand points is that near to one.
TEST(SurfaceElements, FindThePointsThatTheyGive) {
    const Lit lit(furnishedRoom());
    const SurfaceElements elements(lit.scene, lit.needs, 500);
    int wrong = 0, asked = 0;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const auto at = elements.place(e, SamplePath(7, static_cast<std::uint32_t>(e)).next2D());
        const Ray ray{at.position + at.geometricNormal * 1e-3F, 0, -at.geometricNormal, 2e-3F};
        Hit hit;
        lit.raycaster->closestHits({&ray, 1}, {&hit, 1}, Targets::Surfaces);
        if (!hit.surface() || lit.scene.materials[lit.scene.meshes[hit.mesh].material].kind != MaterialKind::Matte) continue;
        const auto met = surfacePoint(lit.scene, lit.needs, ray, hit);
        ++asked;
        if (elements.at(hit.mesh, hit.triangle, hit.u, hit.v, met.frontFace) != e) ++wrong;
    }
    EXPECT_GT(asked, 900);
    EXPECT_LE(wrong, asked / 100);
}

/// A cube of side 4 m, a lamp in its middle, with or without its ceiling.
Scene cube(float reflectance, bool open) {
    SceneBuilder b;
    const auto matte = b.matte(reflectance);
    b.quad({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, matte).quad({0, 0, 0}, {0, 0, 4}, {4, 0, 0}, matte).quad({0, 4, 0}, {4, 0, 0}, {0, 0, 4}, matte);
    b.quad({0, 0, 0}, {0, 4, 0}, {0, 0, 4}, matte).quad({4, 0, 0}, {0, 0, 4}, {0, 4, 0}, matte);
    if (!open) b.quad({0, 0, 4}, {0, 4, 0}, {4, 0, 0}, matte);
    return b.isotropic({2, 2, 2}, 10000).build();
}

// Emitted = absorbed + remaining + lost. 10,000 lm leave the lamp: all reach a closed room's walls, 5/6 those of a cube without
// a ceiling. Tolerance: `straight` is a mean of 24 samples in each of 1,500 elements whose values spread by half their
// mean about them (I cos / d^2 over an element: a tenth): 1e-3. The other terms come of 96 links each, whose row sums are exact
// in a closed room and carry noise of sqrt(p (1 - p) / (96 N)) = 1e-3 of the light exchanged where 1/6 is lost; a third of it is
// noise of how often who is seen, 1 / sqrt(96 N) = 2.6e-3 of what the elements differ by. 1 % is four of these together.
TEST(RadiosityBalance, KeepsEveryLumen) {
    for (const float reflectance : {0.2F, 0.5F, 0.8F, 0.95F}) {
        const Lit lit(cube(reflectance, false));
        const auto field = fieldOf(lit);
        const auto& b = field->balance();
        EXPECT_NEAR(b.straight, 10000, 40);
        EXPECT_NEAR(b.absorbed, 10000, 100) << reflectance;
        EXPECT_EQ(b.lost, 0) << "a closed room loses nothing";
        EXPECT_NEAR(b.byOthers(), 0, 100);
        EXPECT_LT(b.remaining, 1e-3 * 10000 / (1 - double{reflectance})) << "at most 1e-7 of the light that goes round";
    }
    const Lit lit(cube(0.8F, true));
    const auto field = fieldOf(lit);
    const auto& b = field->balance();
    EXPECT_NEAR(b.straight, 10000 * 5 / 6.0, 40);
    EXPECT_GT(b.lost, 1000);
    EXPECT_NEAR(b.absorbed + b.lost, b.straight, 100);
}

// By nature: an element that lies under a wall on both sides takes light on one and gives it on the other. Two rooms share a
// wall that meets the floor's elements inside; the dark room is not dark, and the finer the elements the darker.
// Invariant: the leak is seen, as large as the card says, and a finer mesh has less.
TEST(Radiosity, LeaksUnderWallsByNature) {
    SceneBuilder b;
    const auto white = b.matte(0.8F);
    b.box({0, 0, 0}, {8, 4, 3}, white, true).quad({3.37F, 0, 0}, {0, 4, 0}, {0, 0, 3}, white);
    const Lit lit(b.isotropic({1.7F, 2, 1.5F}, 10000).build());
    const auto dark = facing({6, 2, 1}, {-1, 0, 0}), bright = facing({1, 2, 1}, {-1, 0, 0});
    const auto leakAt = [&](double effort) {
        AlgorithmSettings settings;
        settings.effort = effort;
        const auto estimator = lit.estimator("radiosity", settings);
        return illuminance(lit, *estimator, dark, 0.02).total.value / illuminance(lit, *estimator, bright, 0.02).total.value;
    };
    const double coarse = leakAt(0.01), usual = leakAt(1);
    EXPECT_GT(usual, 0.005);
    EXPECT_LT(usual, 0.03);
    EXPECT_LT(usual, coarse / 3);
    EXPECT_EQ(illuminance(lit, *lit.estimator("path"), dark, 0.02).total.value, 0);
}

}  // namespace
}  // namespace luxdeck::test
