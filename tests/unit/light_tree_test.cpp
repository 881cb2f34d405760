// The hierarchy over many lights: what it says of its choices, and that it leaves no light out.
#include "engine/sampling/light_tree.h"

#include "engine/core/statistics.h"
#include "engine/sampling/light_sampler.h"
#include "engine/sampling/sobol.h"
#include "tests/support/chi_square.h"
#include "tests/support/openings.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::test {
namespace {

CandelaTable narrow() {
    return axialTable([](double v) { return v < 20 ? 4000 * std::exp(-v * v / 30) : 0.0; });
}
CandelaTable wide() {
    return axialTable([](double v) { return v < 90 ? 300 + 200 * std::cos(v * kDegree) : 0.0; });
}

/// Luminaires of two products in a box of 30 x 20 x 3 m, aimed anywhere downwards, of differing flux; and a ball that
/// glows outside.
Scene lamps(int count, bool ball, LuminousOpening opening = {}) {
    SceneBuilder b;
    if (ball) b.sphere({8, 22, 3}, 0.5F, b.glowing(2000, 0), false, 12);
    b.luminaire({0, 0, 0}, narrow(), opening).luminaire({0, 0, 0}, wide(), opening);
    Scene scene = b.build();
    scene.luminaires.clear();
    RandomStream random(3);
    const auto number = [&](double low, double high) { return static_cast<float>(low + (high - low) * random.uniform()); };
    for (int i = 0; i < count; ++i) {
        Luminaire l;
        l.type = static_cast<std::uint32_t>(i % 2);
        l.position = {number(0, 30), number(0, 20), number(3, 6)};
        l.frame = Frame::about(Vec3(number(-0.5, 0.5), number(-0.5, 0.5), 1).normalized());
        l.fluxScale = number(0.2, 3);
        scene.luminaires.push_back(l);
    }
    return scene;
}

std::vector<Receiver> receivers() {
    return {{{15, 10, 0}, {0, 0, 1}}, {{0, 0, 0.8F}, Vec3(1, 1, 0).normalized()}, {{4, 7, 4.5F}, {0, 0, 0}},
            {{100, -50, 1}, Vec3(-1, 0.5F, 0).normalized()}, {{10, 10, 8}, {0, 0, 1}}};
}

/// The tree over luminaires as the sampler grows it.
LightTree treeOf(const Scene& scene) {
    std::vector<float> maps(2 * LightTree::kMapSide * LightTree::kMapSide, 1.0F);
    for (std::size_t i = 0; i < maps.size() / 2; ++i) maps[i] = i % 7 == 0 ? 50.0F : 0.0F;  // rough: the worst case
    std::vector<TreeLight> lights;
    for (const auto& l : scene.luminaires)
        lights.push_back({l.position, {0.1F, 0.1F, 0.01F}, l.frame, l.type, static_cast<float>(l.fluxScale), static_cast<float>(l.fluxScale)});
    return {lights, maps};
}

// 2e-5: products of up to six float quotients, each off by a few 6e-8, summed in double.
TEST(LightTree, ProbabilitiesAddUpToOneAndNoneIsZero) {
    for (const int count : {1, 2, 9, 100, 2000}) {
        const auto tree = treeOf(lamps(count, false));
        for (const auto& at : receivers()) {
            double sum = 0;
            for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
                const float p = tree.probability(at, i);
                ASSERT_GT(p, 0) << "light " << i;
                sum += p;
            }
            EXPECT_NEAR(sum, 1, 2e-5) << count << " lights from " << at.position;
        }
    }
}

// 40,000 draws among 100 lights at five receivers: z below 4, false alarm 2e-4.
TEST(LightTree, ChoosesAsItSays) {
    constexpr int kLights = 100, kDraws = 40000;
    const auto tree = treeOf(lamps(kLights, false));
    RandomStream random(11);
    for (const auto& at : receivers()) {
        std::vector<double> counts(kLights), expected;
        for (int i = 0; i < kDraws; ++i) {
            const auto draw = tree.draw(at, static_cast<float>(random.uniform() * 0.9999999));
            ASSERT_NEAR(draw.probability / tree.probability(at, draw.light), 1, 1e-5) << "the same products in the other order";
            ++counts[draw.light];
        }
        for (std::uint32_t i = 0; i < kLights; ++i) expected.push_back(kDraws * double{tree.probability(at, i)});
        EXPECT_LT(chiSquareZ(counts, expected), 4) << at.position;
    }
}

TEST(LightTree, LightsInOnePlaceAndAtTheReceiver) {
    const std::vector<float> map(LightTree::kMapSide * LightTree::kMapSide, 1.0F);
    const std::vector<TreeLight> lights(300, TreeLight{{1, 2, 3}, {0, 0, 0}, {}, 0, 1, 1});
    const LightTree tree(lights, map);
    for (const Vec3& p : {Vec3(1, 2, 3), Vec3(0, 0, 0)}) {
        double sum = 0;
        for (std::uint32_t i = 0; i < lights.size(); ++i) sum += tree.probability({p}, i);
        EXPECT_NEAR(sum, 1, 2e-5);
        EXPECT_LT(tree.draw({p}, 0x1.fffffep-1F).light, lights.size());
        EXPECT_LT(tree.draw({p}, 0).light, lights.size());
    }
}

/// Mean and 95 % interval of the illuminance by 16 sets of samples.
Interval lux(const LightSampler& lights, const Receiver& at, std::uint32_t samples) {
    std::vector<double> means;
    for (std::uint64_t set = 0; set < 16; ++set) {
        double sum = 0;
        for (std::uint32_t i = 0; i < samples; ++i) {
            SamplePath path(streamSeed(21, set), i);
            const float select = path.next1D();
            const auto s = lights.sample(at, select, path.next2D());
            sum += double{s.weight.g} * (at.normal == Vec3(0, 0, 0) ? 1.0F : std::max(0.0F, dot(s.direction, at.normal)));
        }
        means.push_back(sum / samples);
    }
    return meanOfReplicates(means);
}

// As many luminaires as are weighed one by one, and the same with the tree: 2 is the ratio of 4 standard errors to a 95 %
// half-width.
TEST(LightTree, SameLightAsWeighingOneByOne) {
    for (const bool extended : {false, true}) {
        const Scene scene = lamps(40, false, extended ? openingOf(OpeningShape::Box, 0.3) : LuminousOpening{});
        auto needs = SceneNeeds::of(scene);
        ASSERT_FALSE(needs.manyLights);
        const LightSampler byOne(scene, needs);
        needs.manyLights = true;
        const LightSampler byTree(scene, needs);
        for (const auto& at : receivers()) {
            const auto one = lux(byOne, at, 4096), tree = lux(byTree, at, 4096);
            EXPECT_NEAR(one.value, tree.value, 2 * std::hypot(one.ci95, tree.ci95) + 1e-4 * one.value) << at.position;
        }
    }
}

// Two thousand luminaires: the sum of all intensities towards the receiver over d^2, in double.
TEST(LightTree, ManyLuminairesGiveTheirSum) {
    const Lit lit(lamps(2000, false));
    ASSERT_TRUE(lit.needs.manyLights);
    for (const auto& at : receivers()) {
        double expected = 0;
        for (const auto& l : lit.scene.luminaires) {
            const Vec3 towards = l.position - at.position;
            const double d = towards.length(), cosine = at.normal == Vec3(0, 0, 0) ? 1 : std::max(0.0F, dot(towards, at.normal)) / d;
            expected += lit.scene.luminaireTypes[l.type].photometry.table.intensity(l.frame.toLocal(-towards.normalized())) * l.outputScale() * cosine / (d * d);
        }
        const auto found = lux(*lit.lights, at, 8192);
        EXPECT_NEAR(found.value, expected, 2 * found.ci95 + 1e-4 * expected) << at.position;
        if (expected > 0) { EXPECT_LT(found.ci95, 0.05 * expected) << at.position; }  // 131,072 samples: a useful tree
    }
}

// Luminaires and a glowing ball of 264 triangles, chosen from one tree; what a ray that meets one of them says of the
// density is what the sample said.
TEST(LightTree, TrianglesBesideLuminaires) {
    const Lit lit(lamps(70, true));
    Receiver at{{8, 18, 2}, Vec3(0, 1, 0.3F).normalized(), true};
    int met = 0;
    for (std::uint32_t i = 0; i < 4096; ++i) {
        SamplePath path(5, i);
        const float select = path.next1D();
        const auto s = lit.lights->sample(at, select, path.next2D());
        if (s.source != kFromSurfaces || !s.lit()) continue;
        const std::vector<Ray> ray{{at.position, 0, s.direction, kInfinity}};
        std::vector<Hit> hit(1);
        lit.raycaster->closestHits(ray, hit, Targets::Surfaces);
        if (!hit[0].surface() || std::abs(hit[0].distance / s.distance - 1) > 1e-4F) continue;  // its far side
        const auto& mesh = lit.scene.meshes[hit[0].mesh];
        const auto& [a, b, c] = mesh.triangles[hit[0].triangle];
        const Vec3 normal = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).normalized();
        const float cosine = -dot(normal, s.direction);
        if (cosine < 0.05F) continue;  // rounding of the cosine
        const float pdf = lit.lights->pdfTriangle(at, hit[0].mesh, hit[0].triangle, hit[0].distance, cosine);
        ASSERT_NEAR(pdf / s.pdfSolidAngle, 1, 2e-3) << "cosines above 0.05 and distances are known to 1e-4";
        ++met;
    }
    EXPECT_GT(met, 500) << "the ball is the brightest thing in sight";
}

}  // namespace
}  // namespace luxdeck::test
