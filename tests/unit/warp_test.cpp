#include "engine/sampling/warp.h"

#include "engine/core/rng.h"
#include "tests/support/chi_square.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace luxdeck {
namespace {

constexpr int kSide = 16, kCount = 1 << 16;

/// chi^2 of warped random points in cells that should all be equally likely: `flatten` undoes the warp by the
/// cumulative distribution of its density, worked out by hand. z < 4: false alarm 3e-5.
double flatZ(const std::function<Vec2(Vec2)>& flattenWarped) {
    RandomStream random(1);
    std::vector<double> counts(kSide * kSide), expected(kSide * kSide, double{kCount} / (kSide * kSide));
    for (int i = 0; i < kCount; ++i) {
        const auto x = static_cast<float>(random.uniform()), y = static_cast<float>(random.uniform());
        const Vec2 cell = flattenWarped({x, y});
        const auto bin = [](float w) { return static_cast<std::size_t>(std::clamp(static_cast<int>(w * kSide), 0, kSide - 1)); };
        ++counts[bin(cell.x) * kSide + bin(cell.y)];
    }
    return test::chiSquareZ(counts, expected);
}

float turn(float x, float y) { return std::atan2(y, x) / (2 * kPi) + 0.5F; }

TEST(Warp, FollowsItsDensity) {
    // Disc: area inside r is r^2. cos / pi: the part with cosine below c is c^2. sin / pi^2: (e - sin e cos e) / pi.
    EXPECT_LT(flatZ([](Vec2 u) { const Vec2 d = concentricDisc(u); return Vec2(d.dot(d), turn(d.x, d.y)); }), 4);
    EXPECT_LT(flatZ([](Vec2 u) { const Vec3 d = cosineHemisphere(u); return Vec2(d.z * d.z, turn(d.x, d.y)); }), 4);
    EXPECT_LT(flatZ([](Vec2 u) {
        const Vec3 d = sineSphere(u);
        const float s = std::sqrt(d.x * d.x + d.y * d.y), e = std::atan2(s, d.z);
        return Vec2((e - s * d.z) / kPi, turn(d.x, d.y));
    }), 4);
}

/// The mean of a function of the direction over a lattice of 512 x 512 midpoints. The integrands below are
/// smooth but for square-root ends: an error of order 512^-1.5 = 9e-5.
double mean(const std::function<Vec3(Vec2)>& warp, const std::function<double(const Vec3&)>& f) {
    constexpr int kLattice = 512;
    double sum = 0;
    for (int y = 0; y < kLattice; ++y)
        for (int x = 0; x < kLattice; ++x)
            sum += f(warp({(static_cast<float>(x) + 0.5F) / kLattice, (static_cast<float>(y) + 0.5F) / kLattice}));
    return sum / (double{kLattice} * kLattice);
}
constexpr double kLatticeError = 9e-5;

TEST(Warp, CosineHemisphereHasItsMeans) {
    EXPECT_NEAR(mean(cosineHemisphere, [](const Vec3& d) { return d.z; }), 2.0 / 3, kLatticeError);
    EXPECT_NEAR(mean(cosineHemisphere, [](const Vec3& d) { return d.z * d.z; }), 0.5, kLatticeError);
    EXPECT_NEAR(mean(cosineHemisphere, [](const Vec3& d) { return d.x; }), 0, kLatticeError);
    EXPECT_NEAR(mean(cosineHemisphere, [](const Vec3& d) { return d.y * d.y; }), 0.25, kLatticeError);
}

TEST(Warp, SineSphereHasItsMeans) {
    const auto sine = [](const Vec3& d) { return std::sqrt(double{d.x} * d.x + double{d.y} * d.y); };
    EXPECT_NEAR(mean(sineSphere, sine), 8 / (3 * kPiD), kLatticeError);
    EXPECT_NEAR(mean(sineSphere, [](const Vec3& d) { return d.z * d.z; }), 0.25, kLatticeError);
    EXPECT_NEAR(mean(sineSphere, [](const Vec3& d) { return d.z; }), 0, kLatticeError);
    EXPECT_NEAR(mean(sineSphere, [](const Vec3& d) { return d.x * d.x; }), 0.375, kLatticeError);
}

TEST(Warp, GivesUnitDirectionsAtTheEnds) {
    const float last = 0x1.fffffep-1F;
    for (const float x : {0.0F, 0x1.0p-24F, 0.25F, 0.5F, 0.75F, last})
        for (const float y : {0.0F, 0x1.0p-24F, 0.25F, 0.5F, 0.75F, last}) {
            const Vec3 c = cosineHemisphere({x, y}), s = sineSphere({x, y});
            EXPECT_NEAR(c.length(), 1, 1e-3F) << x << ", " << y;  // at the rim z = sqrt(rounding of 1 - r^2), up to 5e-4
            EXPECT_NEAR(s.length(), 1, 1e-6F) << x << ", " << y;
            EXPECT_GE(c.z, 0.0F);
        }
}

}  // namespace
}  // namespace luxdeck
