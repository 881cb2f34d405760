// Directions and moments of the irradiance volume: the map and its inverse, closed forms, quadrature by other means.
#include "engine/volume/field.h"
#include "engine/volume/moments.h"

#include "engine/core/rng.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace luxdeck::test {
namespace {

TEST(DirectionBins, FindTheBinThatADirectionWasMadeIn) {
    for (const int side : {2, 9, 17, 18}) {
        const DirectionBins bins(side);
        for (int bin = 0; bin < bins.count(); ++bin)
            for (const float u : {0.01F, 0.3F, 0.5F, 0.99F})
                for (const float v : {0.01F, 0.5F, 0.77F, 0.99F}) ASSERT_EQ(bins.binOf(bins.direction(bin, {u, v})), bin) << side << " " << u << " " << v;
    }
}

// Bins of equal solid angle hold equally many of uniform directions. False alarm of the chi-square test: 1e-4.
TEST(DirectionBins, HaveEqualSolidAngles) {
    const DirectionBins bins(9);
    std::vector<double> counts(static_cast<std::size_t>(bins.count()));
    RandomStream random(7);
    constexpr int kDraws = 200000;
    for (int i = 0; i < kDraws; ++i) {
        const double z = 2 * random.uniform() - 1, angle = 2 * kPiD * random.uniform(), r = std::sqrt(1 - z * z);
        ++counts[static_cast<std::size_t>(bins.binOf(Vec3(Vec3d(r * std::cos(angle), r * std::sin(angle), z))))];
    }
    double chi = 0;
    const double expected = static_cast<double>(kDraws) / bins.count();
    for (const double c : counts) chi += (c - expected) * (c - expected) / expected;
    // 161 degrees of freedom: mean 161, standard deviation 17.9; the 1e-4 quantile is 161 + 4.1 * 17.9.
    EXPECT_LT(chi, 235);
}

TEST(DirectionBins, BlendBetweenBinsAcrossTheEquator) {
    const DirectionBins bins(9);
    for (int bin = 0; bin < bins.count(); ++bin) {  // at a centre: that bin alone
        const auto blend = bins.blend(bins.centre(bin));
        float own = 0, all = 0;
        for (int i = 0; i < 4; ++i) all += blend.weight[i], own += blend.bin[i] == bin ? blend.weight[i] : 0;
        EXPECT_NEAR(own, 1, 1e-4);
        EXPECT_NEAR(all, 1, 1e-6);
    }
    // On the equator both hemispheres count alike.
    const auto blend = bins.blend(Vec3(std::cos(0.1F), std::sin(0.1F), 0));
    float upper = 0;
    for (int i = 0; i < 4; ++i) upper += blend.bin[i] < 81 ? blend.weight[i] : 0;
    EXPECT_NEAR(upper, 0.5F, 1e-3F);
}

/// The moment of a sphere of radiances, one a bin, by plain summation over a fine grid of directions: another way than the
/// adaptive one that is tested. Its own error: the midpoint rule on 48 x 48 parts of each of 32 bins.
double momentByBruteForce(const DirectionBins& bins, const std::vector<double>& radiance, const Vec3d& out, int order) {
    constexpr int kFine = 192;
    double sum = 0;
    for (int bin = 0; bin < bins.count(); ++bin) {
        double kernel = 0;
        const int side = bins.side(), cell = bin % (side * side);
        for (int i = 0; i < kFine * kFine; ++i) {
            const double u = (cell % side + (i % kFine + 0.5) / kFine) / side, v = (cell / side + (i / kFine + 0.5) / kFine) / side;
            auto d = concentricHemisphere(u, v);
            if (bin >= side * side) d.z = -d.z;
            kernel += std::pow(std::max(0.0, d.dot(out)), order);
        }
        sum += radiance[static_cast<std::size_t>(bin)] * kernel / (kFine * kFine) * bins.solidAngleSr();
    }
    return 0.5 * (order + 1) * sum;
}

// Moments of radiances that differ by bin, against summation: to 1e-6 of the value, as asked for. The summation's midpoint
// rule on parts of 0.003 rad leaves n^2 0.003^2 / 24 = 4e-7 n^2 where it is smooth and less than that at the horizon: so
// the highest order tested here is judged by 1e-5 (100^2 is out of its reach, and checked on the axis below).
TEST(Moments, AreThoseOfQuadrature) {
    const DirectionBins bins(4);
    RandomStream random(3);
    std::vector<double> radiance;
    for (int i = 0; i < bins.count(); ++i) radiance.push_back(random.uniform());
    for (const int order : {1, 2, 10}) {
        const MomentWeights weights(bins, order, Quadrature::Exact);
        for (int out = 0; out < bins.count(); out += 5) {
            double got = 0;
            for (int in = 0; in < bins.count(); ++in) got += radiance[static_cast<std::size_t>(in)] * weights.of(in)[static_cast<std::size_t>(out)];
            const double expected = momentByBruteForce(bins, radiance, Vec3d(bins.centre(out)), order);
            EXPECT_NEAR(got / expected, 1, order > 2 ? 1e-5 : 2e-6) << order << " " << out;
        }
    }
}

// Radiance of a cap about the axis, which is 1 within the bins of a pattern that is symmetric about it, has no closed
// form; the weights of all bins of the upper hemisphere about +z have: (n + 1) / 2 * 2 pi / (n + 1) = pi, and of those
// above a height h exactly pi (1 - h^(n+1)). Rings of the concentric map end at |z| = 1 - r^2.
TEST(Moments, OfCapsAreClosedForms) {
    const DirectionBins bins(17);
    const int pole = bins.binOf({0, 0, 1});
    for (const int order : {1, 2, 10, 100}) {
        const MomentWeights weights(bins, order, Quadrature::Exact);
        for (int ring = 0; ring <= 8; ++ring) {  // bins at most `ring` from the middle of the square
            double sum = 0;
            for (int v = 8 - ring; v <= 8 + ring; ++v)
                for (int u = 8 - ring; u <= 8 + ring; ++u) sum += weights.of(v * 17 + u)[static_cast<std::size_t>(pole)];
            const double radius = (2 * ring + 1) / 17.0, height = 1 - radius * radius;
            const double expected = kPiD * (1 - std::pow(std::max(height, 0.0), order + 1));
            EXPECT_NEAR(sum / expected, 1, 1e-6) << order << " ring " << ring;
        }
    }
}

// Invariant: a uniform field gives pi L in every direction, whatever the order, to the rounding of 578 terms in float.
TEST(Moments, OfAUniformFieldArePi) {
    const DirectionBins bins(17);
    for (const int order : {1, 2, 10, 100, 10000, 1000000}) {
        const MomentWeights weights(bins, order, Quadrature::Exact);
        std::vector<double> sums(static_cast<std::size_t>(bins.count()));
        for (int in = 0; in < bins.count(); ++in)
            for (std::size_t out = 0; out < sums.size(); ++out) {
                ASSERT_TRUE(std::isfinite(weights.of(in)[out]) && weights.of(in)[out] >= 0) << order;
                sums[out] += weights.of(in)[out];
            }
        for (const double sum : sums) ASSERT_NEAR(sum, kPiD, 578 * kPiD * 0x1p-24 / 10) << order;  // a tenth of the worst case
    }
}

// The thesis' sums at bin centres are within 1 % of irradiance, and without meaning at order 10^4: what Exact is for.
TEST(Moments, AtBinCentresAreTheBaseline) {
    const DirectionBins bins(17);
    const auto uniform = [&](int order) {
        const MomentWeights weights(bins, order, Quadrature::Midpoint);
        double sum = 0;
        for (int in = 0; in < bins.count(); ++in) sum += weights.of(in)[0];
        return sum;
    };
    EXPECT_NEAR(uniform(1), kPiD, 0.01 * kPiD);
    EXPECT_GT(uniform(10000), 10 * kPiD);
}

TEST(Moments, KernelOfOrderOneIsTheCosine) {
    for (const float c : {-0.5F, 0.0F, 1e-30F, 0.3F, 1.0F}) EXPECT_EQ(momentKernel(1, c), std::max(c, 0.0F));
    EXPECT_EQ(momentKernel(10000, 1.0F), 5000.5F);
    EXPECT_EQ(momentKernel(1000000, 0.5F), 0.0F);  // underflows to nothing, not to NaN
}

// Orthonormal over the sphere: the integral of products is the unit matrix, to the midpoint rule's error on 8,192 bins.
TEST(SphericalHarmonics, AreOrthonormal) {
    constexpr int kDegree = 8;
    constexpr std::size_t kTerms = 81;
    const DirectionBins bins(64);
    std::vector<double> products(kTerms * kTerms);
    std::vector<float> y(kTerms);
    for (int bin = 0; bin < bins.count(); ++bin) {
        sphericalHarmonics(bins.centre(bin), kDegree, y);
        for (std::size_t i = 0; i < kTerms; ++i)
            for (std::size_t j = 0; j < kTerms; ++j) products[i * kTerms + j] += double{y[i]} * y[j] * bins.solidAngleSr();
    }
    for (std::size_t i = 0; i < kTerms; ++i)
        for (std::size_t j = 0; j < kTerms; ++j) EXPECT_NEAR(products[i * kTerms + j], i == j ? 1 : 0, 0.01) << i << " " << j;
}

}  // namespace
}  // namespace luxdeck::test
