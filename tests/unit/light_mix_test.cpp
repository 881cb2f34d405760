// Emitting triangles, mixes of lights and their chances.
#include "engine/core/statistics.h"
#include "engine/sampling/light_sampler.h"
#include "engine/sampling/sobol.h"
#include "tests/support/openings.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::test {
namespace {

/// Illuminance from a uniform polygon wholly above the plane. Source: Lambert's contour formula.
double polygonLux(const std::vector<Vec3d>& corners, const Receiver& at, double radiance) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d a = (corners[i] - Vec3d(at.position)).normalized(), b = (corners[(i + 1) % corners.size()] - Vec3d(at.position)).normalized();
        const Vec3d c = a.cross(b);
        sum += std::atan2(c.length(), a.dot(b)) * Vec3d(at.normal).dot(c.normalized());
    }
    return std::abs(sum) * radiance / 2;
}

LightSample draw(const LightSampler& lights, const Receiver& at, SamplePath& path) {
    const float select = path.next1D();
    return lights.sample(at, select, path.next2D());
}

/// Illuminance by samples, 16 sets of 4096.
Interval lux(const LightSampler& lights, const Receiver& at) {
    std::vector<double> means;
    for (std::uint64_t set = 0; set < 16; ++set) {
        double sum = 0;
        for (std::uint32_t i = 0; i < 4096; ++i) {
            SamplePath path(streamSeed(8, set), i);
            const auto s = draw(lights, at, path);
            sum += double{s.weight.g} * std::max(0.0F, dot(s.direction, at.normal));
        }
        means.push_back(sum / 4096);
    }
    return meanOfReplicates(means);
}

/// 2 is the ratio of 4 standard errors to a 95 % half-width; 1e-4 for float sums.
void expectLux(const LightSampler& lights, const Receiver& at, double expected) {
    const auto mean = lux(lights, at);
    EXPECT_NEAR(mean.value, expected, 2 * mean.ci95 + 1e-4 * expected) << at.position;
}

const Receiver kFloor{{0, 0, 0}, {0, 0, 1}};
const std::vector<Vec3d> kQuad{{-1, -1, 2}, {-1, 1, 2}, {0.5, 1, 2}, {0.5, -1, 2}};

SceneBuilder& downwardQuad(SceneBuilder& b, float radiance, bool oneSided = true) {
    Material m;
    m.emission = Rgb(radiance), m.oneSidedEmission = oneSided;
    return b.quad({-1, -1, 2}, {0, 2, 0}, {1.5F, 0, 0}, b.material(m), 3);
}

TEST(LightMix, EmittingSurfaces) {
    SceneBuilder b;
    const Lit lit(downwardQuad(b, 1000).build());
    expectLux(*lit.lights, kFloor, polygonLux(kQuad, kFloor, 1000));
    const Receiver aside{{2, 1, 0.5F}, Vec3(-1, 0, 0.4F).normalized()};
    expectLux(*lit.lights, aside, polygonLux(kQuad, aside, 1000));
}

TEST(LightMix, OneSidedSurfacesGiveNothingToTheirBack) {
    const Receiver above{{0, 0, 3}, {0, 0, -1}};
    for (const bool oneSided : {true, false}) {
        SceneBuilder b;
        const Lit lit(downwardQuad(b, 1000, oneSided).build());
        expectLux(*lit.lights, above, oneSided ? 0 : polygonLux(kQuad, above, 1000));
    }
}

// Many kinds of light at once: the sum of what each gives alone.
TEST(LightMix, LightsAddUp) {
    const auto add = [](SceneBuilder& b, int which) {
        if (which == 0) downwardQuad(b, 300);
        if (which == 1) b.isotropic({2, 0, 3}, 3000);
        if (which == 2) b.lambertian({-2, 1, 2.5F}, 800, openingOf(OpeningShape::Rectangle));
        if (which == 3) b.isotropic({0, 2, 1.5F}, 900, openingOf(OpeningShape::Sphere, 0.3));
        if (which == 4) b.lambertian({0, -3, 2.5F}, 0, {});  // dark: never chosen
    };
    const Receiver at{{0.2F, 0.1F, 0}, Vec3(0.1F, 0, 1).normalized()};
    double sum = 0, variance = 0;
    SceneBuilder all;
    for (int which = 0; which < 5; ++which) {
        SceneBuilder alone;
        add(alone, which), add(all, which);
        const Lit lit(alone.build());
        const auto one = lux(*lit.lights, at);
        sum += one.value, variance += one.ci95 * one.ci95;
    }
    const Lit lit(all.build());
    const auto mixed = lux(*lit.lights, at);
    EXPECT_NEAR(mixed.value, sum, 2 * std::sqrt(variance + mixed.ci95 * mixed.ci95) + 1e-4 * sum);
    EXPECT_GT(sum, 100);
}

TEST(LightMix, MoreLuminairesThanAreWeighedOneByOne) {
    SceneBuilder b;
    double expected = 0;
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j) {
            const Vec3 p{static_cast<float>(i) - 4.3F, static_cast<float>(j) - 4.6F, 2.5F + 0.1F * static_cast<float>(i)};
            b.isotropic(p, 100.0 * (1 + j));
            const double d = p.length();
            expected += 100.0 * (1 + j) / (4 * kPiD) * p.z / (d * d * d);
        }
    const Lit lit(b.build());
    ASSERT_TRUE(lit.needs.manyLights);
    expectLux(*lit.lights, kFloor, expected);
}

TEST(LightMix, NoLightsNoSamples) {
    SceneBuilder b;
    b.quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, b.matte(0.5F));
    const Lit lit(b.build());
    EXPECT_TRUE(lit.lights->empty());
    EXPECT_FALSE(lit.lights->sample(kFloor, 0.5F, {0.5F, 0.5F}).lit());
    SceneBuilder dark;
    const Lit off(dark.lambertian({0, 0, 2}, 0, openingOf(OpeningShape::Disc)).build());
    EXPECT_FALSE(off.lights->sample(kFloor, 0.5F, {0.5F, 0.5F}).lit());
}

// What sample() says of the density is what pdfTriangle() says, and its integral over the surface is the chance.
TEST(LightMix, DensitiesOfTrianglesAgree) {
    SceneBuilder b;
    downwardQuad(b, 1000);
    b.isotropic({2, 0, 3}, 3000);
    const Lit lit(b.build());
    Receiver at{{0.3F, -0.2F, 0.5F}, {0, 0, 1}, true};
    int fromTriangles = 0;
    constexpr std::uint32_t kCount = 1 << 14;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        SamplePath path(9, i);
        const auto s = draw(*lit.lights, at, path);
        if (s.pdfSolidAngle == 0) continue;
        ++fromTriangles;
        const std::vector<Ray> ray{{at.position, 0, s.direction, kInfinity}};
        std::vector<Hit> hit(1);
        lit.raycaster->closestHits(ray, hit, Targets::Surfaces);
        if (!hit[0].surface()) continue;  // the very rim
        const float pdf = lit.lights->pdfTriangle(at, hit[0].mesh, hit[0].triangle, hit[0].distance, s.direction.z);
        ASSERT_NEAR(pdf / s.pdfSolidAngle, 1, 1e-3) << "two float distances and cosines";
    }
    // Integral of pdf over solid angle = sum over the triangles, each by midpoints of its parts.
    double chance = 0;
    const auto& mesh = lit.scene.meshes[0];
    constexpr int kParts = 24;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, bb, c] = mesh.triangles[t];
        const Vec3 p = mesh.positions[a], u = mesh.positions[bb] - p, v = mesh.positions[c] - p;
        const double part = 0.5 * cross(u, v).length() / (kParts * kParts);
        for (int i = 0; i < kParts; ++i)
            for (int j = 0; j < 2 * i + 1; ++j) {  // row i of the triangle's kParts^2 equal parts
                const int whole = j / 2;
                const float third = j % 2 == 0 ? 1.0F / 3 : 2.0F / 3, r = (static_cast<float>(i) + (j % 2 == 0 ? 2.0F / 3 : 1.0F / 3)) / kParts;
                const float s = (static_cast<float>(whole) + third) / kParts;
                const Vec3 towards = p + u * (r - s) + v * s - at.position;
                const float d = towards.length(), cosine = towards.z / d;
                chance += part * cosine / (d * d) * lit.lights->pdfTriangle(at, 0, t, d, cosine);
            }
    }
    // The samples are stratified in uSelect, the chance of triangles is an interval of it: exact to 2^-14 or so.
    EXPECT_NEAR(static_cast<double>(fromTriangles) / kCount, chance, 2e-3);
    EXPECT_LT(chance, 1);
    at.glossy = false, at.position = {0, 0, -20};
    EXPECT_EQ(lit.lights->pdfTriangle(at, 0, 0, 22, 0.9F), kInfinity) << "small and far: next-event estimation alone";
    EXPECT_EQ(lit.lights->pdfTriangle(at, 0, 0, 22, -0.1F), 0) << "its back";
}

}  // namespace
}  // namespace luxdeck::test
