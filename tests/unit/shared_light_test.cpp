// Sensors that share the light which each other's paths found, and lamps sought by way of mirrors and panes.
#include "engine/transport/sensor/illuminance.h"
#include "engine/transport/surface/glass.h"

#include "analysis/grids/measurement.h"
#include "analysis/grids/neighbours.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace luxdeck::test {
namespace {

/// Of about 100 comparisons in this file, one such deviation is expected in 2,500 runs of other seeds: 4.5 sigma of
/// Student's t with 31 degrees of freedom has the two-sided probability 9e-5, in both estimates together far less.
constexpr double kSigmas = 4.5;

std::vector<Target> rowOfSensors(int nx, int ny, SensorKind kind = SensorKind::Planar) {
    std::vector<Target> targets;
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
            Target t;
            t.sensor = {{0.5F + 0.45F * static_cast<float>(x), 0.6F + 0.7F * static_cast<float>(y), 0.8F}, {0, 0, 1}, kind, {}};
            t.stream = targets.size();
            targets.push_back(t);
        }
    return targets;
}

/// Sums of all targets, asked together or one by one.
std::vector<PointSums> sums(const Lit& lit, const std::string& algorithm, const std::vector<Target>& targets, bool together,
                            std::uint32_t perReplicate, std::uint64_t seed = 1) {
    const auto estimator = lit.estimator(algorithm);
    TransportCounters counters;
    std::vector<std::size_t> members(targets.size());
    std::iota(members.begin(), members.end(), std::size_t{0});
    if (together) return measureTogether(*estimator, lit.scene.weights, targets, members, seed, std::vector<std::uint32_t>(members.size(), 0), perReplicate, counters);
    std::vector<PointSums> all;
    for (const auto& target : targets) all.push_back(measure(*estimator, lit.scene.weights, target, seed, 0, perReplicate, counters));
    return all;
}

double standardError(const std::array<double, kReplicates>& means) {
    MeanVariance mv;
    for (const double m : means) mv.add(m);
    return std::sqrt(mv.meanVariance());
}

void expectSame(const std::vector<PointSums>& a, const std::vector<PointSums>& b, const std::string& what) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double sigma = std::hypot(standardError(a[i].totalMeans()), standardError(b[i].totalMeans()));
        EXPECT_NEAR(a[i].total().value, b[i].total().value, kSigmas * sigma + 1e-5 * b[i].total().value) << what << ", sensor " << i;
    }
}

// Invariant: sharing changes the noise, never the mean. A room with a pane, a rough metal, coloured walls; both kinds of sensors.
TEST(SharedLight, HasTheMeanThatPathsHave) {
    const Lit lit(furnishedRoom());
    for (const auto kind : {SensorKind::Planar, SensorKind::Cylindrical}) {
        const auto targets = rowOfSensors(6, 4, kind);
        expectSame(sums(lit, "shared", targets, true, 256), sums(lit, "path", targets, false, 512, 2), "furnished room");
    }
}

// The same where mirror, glass, texture, sky and emitting surfaces are in play.
TEST(SharedLight, HasTheMeanThatPathsHaveInARichRoom) {
    const Lit lit(richRoom());
    const auto box = lit.scene.bounds();
    std::vector<Target> targets;
    for (int i = 0; i < 9; ++i) {
        Target t;
        const Vec3 part(0.2F + 0.3F * static_cast<float>(i % 3), 0.2F + 0.3F * static_cast<float>(i / 3), 0.3F);
        t.sensor = {box.min + box.size() * part, {0, 0, 1}, SensorKind::Planar, {}};
        t.stream = targets.size();
        targets.push_back(t);
    }
    expectSame(sums(lit, "shared", targets, true, 512), sums(lit, "path", targets, false, 1024, 2), "rich room");
}

// In a matte room all indirect light can be shared. Invariant: 24 neighbours know it at least four times better in
// variance for the same paths, half of which end early (the ideal of equal kernels is 12).
TEST(SharedLight, LowersTheVarianceOfIndirectLight) {
    const Lit lit(cubeRoom(0.7F, 3000));
    const auto targets = rowOfSensors(6, 4);
    const auto variance = [](const std::vector<PointSums>& all) {
        double sum = 0;
        for (const auto& s : all) sum += std::pow(standardError(s.indirectMeans()), 2);
        return sum;
    };
    EXPECT_LT(4 * variance(sums(lit, "shared", targets, true, 64)), variance(sums(lit, "path", targets, false, 64)));
}

TEST(SharedLight, OfASensorAloneIsItsOwn) {
    const Lit lit(furnishedRoom());
    const auto targets = rowOfSensors(1, 1);
    expectSame(sums(lit, "shared", targets, false, 512), sums(lit, "path", targets, false, 512, 2), "alone");
}

// Invariant: every target is in one group, groups are small, and grids stay apart.
TEST(Neighbours, GroupEveryTargetOnce) {
    auto targets = rowOfSensors(9, 5);
    for (std::size_t i = 20; i < targets.size(); ++i) targets[i].grid = 1;
    targets[7].radiance = true;
    const auto groups = neighbours(targets, 8);
    std::vector<int> seen(targets.size());
    for (const auto& group : groups) {
        EXPECT_LE(group.size(), 8U);
        for (const auto i : group) {
            ++seen[i];
            EXPECT_EQ(targets[i].grid, targets[group.front()].grid);
            EXPECT_TRUE(i != 7 || group.size() == 1);
        }
    }
    EXPECT_EQ(seen, std::vector<int>(targets.size(), 1));
}

Material flatMirror(MaterialKind kind) {
    Material m;
    m.kind = kind;
    if (kind == MaterialKind::Mirror) m.specular = Rgb(0.9F);
    else m.transmittance = Rgb(0.8F), m.ior = 1.52F;
    return m;
}

/// A lamp above a sensor that faces sideways to a mirror or pane in the plane x = 2: by way of it alone light comes.
Lit facingAMirror(MaterialKind kind, const LuminousOpening& opening) {
    SceneBuilder b;
    b.isotropic({0.1F, 0, 1.5F}, 4 * kPiD * 1000, opening);
    b.quad({2, -3, -3}, {0, 6, 0}, {0, 0, 6}, b.material(flatMirror(kind)));
    b.quad({0.05F, -1, -0.5F}, {0, 2, 0}, {0, 0, 1.6F}, b.matte(0.0F));  // between lamp and sensor, black
    return Lit(b.build());
}

// Closed form: the mirrored lamp is a lamp, dimmed by the reflectance at that angle: E = R I cos / d^2. The sphere is
// small: 1e-4 of the distance squared away from a point.
TEST(MirroredLight, OfALampIsTheLampBehindTheMirror) {
    for (const auto kind : {MaterialKind::Mirror, MaterialKind::ThinGlass})
        for (const auto& opening : {LuminousOpening{}, LuminousOpening{OpeningShape::Sphere, 0.05, 0.05, 0.05}}) {
            const auto lit = facingAMirror(kind, opening);
            Target target;
            target.sensor = {{0.5F, 0, 0}, {1, 0, 0}, SensorKind::Planar, {}};
            const Vec3 way = Vec3(3.9F, 0, 1.5F) - target.sensor.position;
            const float cosine = way.x / way.length();
            const double reflectance = kind == MaterialKind::Mirror ? 0.9 : double{paneLight(Rgb(0.8F), 1.52F, cosine).reflected.g};
            const double expected = reflectance * 1000 * cosine / way.length2();
            for (const auto* algorithm : {"path", "shared"}) {
                const auto got = sums(lit, algorithm, {target}, false, 64).front();
                const double sigma = standardError(got.totalMeans());
                EXPECT_NEAR(got.total().value, expected, kSigmas * sigma + 1e-3 * expected) << algorithm;
                EXPECT_LT(sigma, 0.02 * expected) << "sought, not met by chance: " << algorithm;
            }
        }
}

// A lamp lights a wall by way of a mirror, and the wall the sensor. Invariant: with mirrors sought or left to chance
// the mean is the same.
TEST(MirroredLight, AtEveryBounceHasTheMeanOfChance) {
    Lit sought(furnishedRoom()), chance(furnishedRoom());
    *chance.mirrors = Mirrors();
    ASSERT_FALSE(sought.mirrors->empty());
    const auto targets = rowOfSensors(4, 3);
    expectSame(sums(sought, "path", targets, false, 1024), sums(chance, "path", targets, false, 8192, 2), "pane");
}

}  // namespace
}  // namespace luxdeck::test
