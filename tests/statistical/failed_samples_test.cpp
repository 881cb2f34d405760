// Surfaces without a value: a pattern that is not a number on a part of a scene. What it reflects is anything from nothing to
// what white paint would (docs/decisions/0011), so every algorithm is asked beside two scenes that have a value there: black
// is what it must find, and white must not lie above what it says may be missing; or the number is withheld.
//
// Bug: a failed sample was averaged in as zero, with the light that it had found before. A sensor under half a sky and half a
// roof without a value had 212 lx where a black roof leaves 281, with an interval of 1 lx.

#include "analysis/grids/measurement.h"
#include "engine/algorithms/registry.h"
#include "engine/core/parallel.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace luxdeck::test {
namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();
constexpr float kBlack = 0, kWhite = 0.9F;

/// Two-sided, Student's t with 31 degrees of freedom: 9e-5 a comparison, of which there are 130 in this file.
constexpr double kSigmas = 4.5;

/// One factor within a region, one without.
class Region final : public Pattern {
public:
    Region(std::function<bool(const Vec3d&)> within, float inside, float outside)
        : within_(std::move(within)), inside_(inside), outside_(outside) {}
    [[nodiscard]] Rgb value(const PatternPoint& at) const override { return Rgb(within_(at.position) ? inside_ : outside_); }
    [[nodiscard]] std::string identity() const override { return std::to_string(inside_); }

private:
    std::function<bool(const Vec3d&)> within_;
    float inside_, outside_;
};

/// A room of which the surfaces in a region reflect this part of light; the others half of it.
Scene roomWith(const std::function<bool(const Vec3d&)>& within, float reflectance) {
    auto scene = cubeRoom(1.0F, 1000);
    scene.patterns.push_back(std::make_shared<Region>(within, reflectance, 0.5F));
    scene.materials[0].reflectancePattern = 0;
    return scene;
}

/// Every surface a mixture of white and black paint, of which the region's fraction has no value.
Scene mixedRoom(const std::function<bool(const Vec3d&)>& within, float reflectance) {
    auto scene = cubeRoom(0.5F, 1000);
    const auto add = [&](float r) {
        Material m;
        m.name = r > 0 ? "white" : "black", m.reflectance = Rgb(r);
        scene.materials.push_back(m);
        return static_cast<std::uint32_t>(scene.materials.size() - 1);
    };
    const auto white = add(kWhite), black = add(0);
    auto& mixed = scene.materials[0];
    mixed.kind = MaterialKind::Mix, mixed.mixFirst = white, mixed.mixSecond = black, mixed.mixPattern = 0;
    scene.patterns.push_back(std::make_shared<Region>(within, reflectance / kWhite, 0.5F));
    return scene;
}

/// Half a uniform sky, half a roof; nothing else.
Scene halfRoof(float reflectance) {
    SceneBuilder b;
    b.quad({0, -500, 3}, {0, 1000, 0}, {500, 0, 0}, b.matte(1));
    b.sky(Sky(SkyKind::Uniform, 100));
    auto scene = b.build();
    scene.patterns.push_back(std::make_shared<Region>([](const Vec3d&) { return true; }, reflectance, 1.0F));
    scene.materials[0].reflectancePattern = 0;
    return scene;
}

enum class Expected { Held, Kept, Withheld };

struct Case {
    std::string name;
    std::function<Scene(float)> scene;  // of the reflectance where there is no value
    Expected expected = Expected::Held; // Kept: not withheld; Held: if not
};

std::vector<Case> cases() {
    const auto half = [](const Vec3d& p) { return p.x < 2; };
    const auto patch = [](const Vec3d& p) { return p.z > 3.9 && std::abs(p.x - 2) < 0.2 && std::abs(p.y - 2) < 0.2; };
    const auto floor = [](const Vec3d& p) { return p.z < 0.1; };
    return {{"half of the room", [=](float r) { return roomWith(half, r); }},
            {"a patch of 0.3 % of the view", [=](float r) { return roomWith(patch, r); }, Expected::Kept},
            {"everywhere", [](float r) { return roomWith([](const Vec3d&) { return true; }, r); }, Expected::Withheld},
            {"half of a mixture", [=](float r) { return mixedRoom(half, r); }},
            {"the floor, which the sensor does not see", [=](float r) { return roomWith(floor, r); }},
            {"half a roof", halfRoof}};
}

PointSums sumsOf(const Lit& lit, const RadianceEstimator& estimator, std::uint32_t perReplicate) {
    Target target;
    target.sensor = {{2, 2, 0.5F}, {0, 0, 1}, SensorKind::Planar, {}};
    if (!lit.scene.luminaires.empty()) target.sensor.position.x = 2.3F;
    else target.sensor.position = {0, 0, 0};
    TransportCounters counters;
    return measure(estimator, lit.scene.weights, target, 1, 0, perReplicate, counters);
}

double standardError(const PointSums& s) {
    MeanVariance mv;
    for (const double m : s.totalMeans()) mv.add(m);
    return std::sqrt(mv.meanVariance());
}

class FailedSamples : public testing::TestWithParam<std::string> {
protected:
    static constexpr std::uint32_t kPerReplicate = 1024;

    [[nodiscard]] static PointSums with(const Case& c, float reflectance) {
        const Lit lit(c.scene(reflectance));
        AlgorithmSettings settings;
        settings.effort = 0.1;
        return sumsOf(lit, *lit.estimator(GetParam(), settings), kPerReplicate);
    }
};

TEST_P(FailedSamples, AreWithinTheIntervalOrTheNumberIsWithheld) {
    const bool reflects = algorithmNamed(GetParam())->interreflection;
    for (const auto& c : cases()) {
        SCOPED_TRACE(c.name);
        const auto black = with(c, kBlack), white = with(c, kWhite), got = with(c, kNoValue);
        const double least = black.total().value, most = white.total().value, value = got.total().value;
        EXPECT_EQ(black.rejected + white.rejected, 0U);
        EXPECT_TRUE(std::isfinite(value));
        EXPECT_TRUE(got.rejected > 0 || !reflects);
        EXPECT_TRUE(got.withheld() || !reflects || c.expected != Expected::Withheld);
        EXPECT_FALSE(got.withheld() && c.expected == Expected::Kept);
        // Other random numbers are used up where paths end; and prepared fields of two scenes differ by their bias.
        const double bias = algorithmNamed(GetParam())->bias * most;
        const double noise = kSigmas * std::hypot(standardError(got), standardError(black)) + bias + 1e-4 * least;
        EXPECT_NEAR(value, least, noise) << "what was found before is kept";
        const double lost = got.lost / static_cast<double>(got.samples());
        // Of n failed samples whose losses vary as an exponential distribution: lost / sqrt(n), and as much for their number.
        const double noiseOfLost = kSigmas * (lost * std::sqrt(2.0 / std::max<double>(1, static_cast<double>(got.rejected))) +
                                              std::hypot(standardError(white), standardError(got))) + bias + 1e-4 * most;
        EXPECT_GE(value + lost, most - noiseOfLost) << "white paint may be there";
        EXPECT_LE(lost, 1.5 * (most - least) + noiseOfLost) << "and no more than that";
        EXPECT_EQ(std::isinf(got.total().ci95), got.withheld());
        EXPECT_GE(got.total().high(), value + lost);
    }
}

std::vector<std::string> everyAlgorithm() {
    std::vector<std::string> names;
    for (const auto& a : algorithms()) names.push_back(a.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, FailedSamples, testing::ValuesIn(everyAlgorithm()), [](const auto& param) { return param.param; });

}  // namespace
}  // namespace luxdeck::test
