#include "engine/transport/surface/microfacet.h"

#include "engine/core/rng.h"
#include "tests/support/chi_square.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace luxdeck::test {
namespace {

Vec3 towards(float cosine, float turn = 0) {
    const float s = std::sqrt(std::max(0.0F, 1 - cosine * cosine));
    return {s * std::cos(turn), s * std::sin(turn), cosine};
}

// The microfacets' area projected along the normal is the surface's: the integral of D cos is 1. Midpoints in the
// substitution tan = alpha * s / (1 - s) that flattens D.
TEST(Ggx, DistributionIsNormalised) {
    for (const float alpha : {0.001F, 0.01F, 0.1F, 0.5F, 1.0F}) {
        double sum = 0;
        constexpr int kSteps = 20'000;
        for (int i = 0; i < kSteps; ++i) {
            const double s = (i + 0.5) / kSteps, t = alpha * s / (1 - s), cosine = 1 / std::sqrt(1 + t * t);
            const double dTheta = alpha / ((1 - s) * (1 - s)) * cosine * cosine / kSteps;
            const float sine = static_cast<float>(t * cosine);
            sum += Ggx{alpha}.distribution({sine, 0, static_cast<float>(cosine)}) * cosine * sine * 2 * kPiD * dTheta;
        }
        EXPECT_NEAR(sum, 1, 1e-4) << alpha;  // float D: 1e-6 each; the last of the steps holds (1 - s)^2 = 1e-9
    }
}

TEST(Ggx, LobeIsReciprocal) {
    RandomStream r(1);
    for (int i = 0; i < 10'000; ++i) {
        const auto direction = [&] { return towards(0.01F + 0.99F * static_cast<float>(r.uniform()), 6.28F * static_cast<float>(r.uniform())); };
        const Vec3 a = direction(), b = direction();
        const Ggx ggx{0.01F + 0.99F * static_cast<float>(r.uniform())};
        EXPECT_NEAR(ggx.lobe(a, b) / ggx.lobe(b, a), 1, 1e-4);  // float rounding of sums of two lambdas
    }
}

// Sampled normals, mirrored, against the density that pdf() states. z < 4: false alarm 3e-5 a case.
TEST(Ggx, SamplesFollowTheirDensity) {
    constexpr int kZ = 12, kTurn = 16, kFine = 40, kCount = 1 << 16;
    for (const float alpha : {0.15F, 0.5F, 1.0F})
        for (const float cosine : {0.15F, 0.6F, 1.0F}) {
            const Ggx ggx{alpha};
            const Vec3 wo = towards(cosine);
            std::vector<double> counts(kZ * kTurn + 1), expected(kZ * kTurn + 1);
            double total = 0;
            for (int z = 0; z < kZ * kFine; ++z)
                for (int t = 0; t < kTurn * kFine; ++t) {
                    const Vec3 wi = towards((static_cast<float>(z) + 0.5F) / (kZ * kFine), 2 * kPi * (static_cast<float>(t) + 0.5F) / (kTurn * kFine));
                    const double p = ggx.pdf(wo, wi) * 2 * kPiD / (kZ * kFine * kTurn * kFine);
                    expected[static_cast<std::size_t>(z / kFine * kTurn + t / kFine)] += p * kCount;
                    total += p;
                }
            ASSERT_LT(total, 1 + 1e-3) << "midpoints of the narrowest lobe";
            expected.back() = kCount * std::max(0.0, 1 - total);  // mirrored below the horizon
            RandomStream r(2);
            for (int i = 0; i < kCount; ++i) {
                const Vec2 u{static_cast<float>(r.uniform()), static_cast<float>(r.uniform())};
                const Vec3 h = ggx.sampleVisible(wo, u), wi = h * (2 * dot(wo, h)) - wo;
                ASSERT_GT(dot(wo, h), -1e-5F) << "a normal that is not visible";
                if (wi.z <= 0) {
                    ++counts.back();
                    continue;
                }
                const float turn = std::atan2(wi.y, wi.x) / (2 * kPi);
                const auto bin = [](float w, int n) { return std::clamp(static_cast<int>(w * static_cast<float>(n)), 0, n - 1); };
                ++counts[static_cast<std::size_t>(bin(wi.z, kZ) * kTurn + bin(turn < 0 ? turn + 1 : turn, kTurn))];
            }
            EXPECT_LT(chiSquareZ(counts, expected), 4) << "alpha " << alpha << " cosine " << cosine;
        }
}

TEST(LobeAlbedo, IsTheIntegralOfTheLobe) {
    // Plain midpoints over the hemisphere. The table is linear between 32 x 32 nodes: its curvature leaves 3e-3.
    constexpr int kZ = 400, kTurn = 200;
    for (const float alpha : {0.2F, 0.5F, 0.9F})
        for (const float cosine : {0.2F, 0.5F, 0.95F}) {
            double bare = 0, grazing = 0;
            const Vec3 wo = towards(cosine);
            for (int z = 0; z < kZ; ++z)
                for (int t = 0; t < kTurn; ++t) {
                    const Vec3 wi = towards((static_cast<float>(z) + 0.5F) / kZ, kPi * (static_cast<float>(t) + 0.5F) / kTurn);
                    const double f = Ggx{alpha}.lobe(wo, wi) * wi.z * 2 * kPiD / (kZ * kTurn);
                    const double c = schlick(dot(wo, (wo + wi).normalized()));
                    bare += f * (1 - c), grazing += f * c;
                }
            const auto e = lobeAlbedo(cosine, alpha);
            EXPECT_NEAR(e.bare, bare, 3e-3) << "alpha " << alpha << " cosine " << cosine;
            EXPECT_NEAR(e.grazing, grazing, 3e-3) << "alpha " << alpha << " cosine " << cosine;
        }
}

TEST(LobeAlbedo, MeanIsTheCosineWeightedMean) {
    for (const float alpha : {0.01F, 0.3F, 1.0F}) {
        double total = 0;
        for (int i = 0; i < 1000; ++i) {
            const float cosine = (static_cast<float>(i) + 0.5F) / 1000;
            total += lobeAlbedo(cosine, alpha).total() * 2 * cosine / 1000;
        }
        EXPECT_NEAR(meanLobeAlbedo(alpha).total(), total, 1e-3) << alpha;  // trapezoid against midpoints
        EXPECT_LE(meanLobeAlbedo(alpha).total(), 1 + 1e-6F);
    }
}

}  // namespace
}  // namespace luxdeck::test
