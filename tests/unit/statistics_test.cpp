#include "engine/core/statistics.h"
#include "engine/core/rng.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace luxdeck {
namespace {

TEST(Interval, RelativeOfZeroTellsExactFromUnknown) {
    EXPECT_EQ((Interval{0.0, 0.0}).relative(), 0.0);
    EXPECT_EQ((Interval{0.0, 1.0}).relative(), std::numeric_limits<double>::infinity());
    EXPECT_DOUBLE_EQ((Interval{-200.0, 10.0}).relative(), 0.05);
}

TEST(StudentT, AgreesWithPrintedTables) {
    // Five decimals in the tables: half a unit of the last one.
    const std::array<std::pair<double, double>, 10> table = {{{1, 12.70620},
                                                              {2, 4.30265},
                                                              {3, 3.18245},
                                                              {4, 2.77645},
                                                              {5, 2.57058},
                                                              {10, 2.22814},
                                                              {15, 2.13145},
                                                              {31, 2.03951},
                                                              {120, 1.97993},
                                                              {1e12, 1.95996}}};
    for (const auto& [dof, t] : table) EXPECT_NEAR(studentT95(dof), t, 5.1e-6) << dof;
}

/// P(|T| < t) by the midpoint rule on the density itself, in u = t / (1 + t): independent of the
/// substitution that statistics.cpp integrates in.
double centralProbability(double t, double nu) {
    constexpr int steps = 200'000;
    const double step = t / (1.0 + t) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double u = (i + 0.5) * step;
        const double x = u / (1.0 - u);
        sum += std::pow(1.0 + x * x / nu, -(nu + 1.0) / 2.0) / ((1.0 - u) * (1.0 - u));
    }
    const double scale = std::tgamma((nu + 1.0) / 2.0) / std::tgamma(nu / 2.0) / std::sqrt(nu * std::numbers::pi);
    return 2.0 * scale * sum * step;
}

TEST(StudentT, HoldsForFractionalDegreesOfFreedom) {
    // The midpoint rule's own error is below 1e-9 here, Simpson's below 1e-8.
    for (const double nu : {1.0, 1.3, 1.7, 2.5, 7.77, 33.3, 150.5}) {
        EXPECT_NEAR(centralProbability(studentT95(nu), nu), 0.95, 2e-8) << nu;
    }
}

TEST(StudentT, FallsSteadilyAcrossItsTwoFormulas) {
    double previous = std::numeric_limits<double>::infinity();
    for (double nu = 1.0; nu < 1e6; nu *= 1.07) {
        const double t = studentT95(nu);
        EXPECT_LT(t, previous) << nu;
        previous = t;
    }
    // Where they meet, at 10,000, the expansion's first term left out is
    // (5 z^5 + 16 z^3 + 3 z) / (96 nu^2) = 2.8e-8, and Simpson's rule adds 1e-8 or less.
    EXPECT_NEAR(studentT95(1e4), studentT95(1e4 * 1.0000001), 4e-8);
}

TEST(MeanOfReplicates, IsStudentsInterval) {
    const std::array<double, 4> x = {9.0, 11.0, 10.0, 14.0};
    const Interval interval = meanOfReplicates(x);
    EXPECT_DOUBLE_EQ(interval.value, 11.0);
    // Sum of squares 14, variance 14 / 3, of the mean 14 / 12; t(3) = 3.18245 to 5e-6.
    EXPECT_NEAR(interval.ci95, 3.18245 * std::sqrt(14.0 / 12.0), 1e-5);
}

TEST(MeanOfReplicates, EqualReplicatesAreExact) {
    const std::array<double, 3> x = {7.0, 7.0, 7.0};
    EXPECT_EQ(meanOfReplicates(x).ci95, 0.0);
}

std::vector<double> noisyGrid(std::size_t points, std::size_t replicates, double spread) {
    RandomStream random(7);
    std::vector<double> values;
    for (std::size_t i = 0; i < points; ++i) {
        for (std::size_t r = 0; r < replicates; ++r) {
            values.push_back(300.0 + spread * static_cast<double>(i) + 10.0 * random.normal());
        }
    }
    return values;
}

TEST(GridInterval, OnePointIsItsOwnMeanAndMinimum) {
    const std::vector<double> values = noisyGrid(1, 16, 0.0);
    const Interval point = meanOfReplicates(values);
    const GridInterval grid = gridInterval(values, 1);
    // The same sums in another order: rounding only.
    EXPECT_NEAR(grid.mean.value, point.value, 1e-12 * point.value);
    EXPECT_NEAR(grid.mean.ci95, point.ci95, 1e-12 * point.value);
    EXPECT_NEAR(grid.minimum.value, point.value, 1e-12 * point.value);
    // The probability beyond 5 sigmas is left out: 3e-7 of the variance.
    EXPECT_NEAR(grid.minimum.ci95, point.ci95, 1e-6 * point.ci95);
    EXPECT_DOUBLE_EQ(grid.uniformity.value, 1.0);
    EXPECT_NEAR(grid.uniformity.ci95, 0.0, 1e-3 * point.relative());  // a root of that 3e-7
}

TEST(GridInterval, ClearMinimumIsThatPointsInterval) {
    const std::vector<double> values = noisyGrid(50, 16, 100.0);  // 40 standard errors apart
    const Interval darkest = meanOfReplicates(std::span(values).first(16));
    const GridInterval grid = gridInterval(values, 50);
    EXPECT_EQ(grid.minimumPoint, 0u);
    EXPECT_NEAR(grid.minimum.value, darkest.value, 1e-5 * darkest.ci95);  // the tail left out, and quadrature
    EXPECT_NEAR(grid.minimum.ci95, darkest.ci95, 1e-5 * darkest.ci95);
}

TEST(GridInterval, MeanIsBetterKnownThanItsPoints) {
    const std::vector<double> values = noisyGrid(100, 16, 0.0);
    const GridInterval grid = gridInterval(values, 100);
    // 100 independent errors of 10 / sqrt(16): 0.25, times 1.96; the variance is known to
    // sqrt(2 / 1500) = 4 %, so its root to 2 %: 10 % is 5 sd (false alarm 6e-7, fixed seed).
    EXPECT_NEAR(grid.mean.ci95, 1.96 * 0.25, 0.1 * 1.96 * 0.25);
}

TEST(GridInterval, MinimumOfTiesIsLiftedAboveTheSmallestPoint) {
    const std::vector<double> values = noisyGrid(16, 16, 0.0);
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 16; ++i) {
        smallest = std::min(smallest, meanOfReplicates(std::span(values).subspan(16 * i, 16)).value);
    }
    const GridInterval grid = gridInterval(values, 16);
    EXPECT_GT(grid.minimum.value, smallest);
    EXPECT_LT(grid.minimum.value, grid.mean.value);
}

TEST(GridInterval, WithoutNoiseItIsExact) {
    const std::vector<double> values = {5, 5, 3, 3, 4, 4, 3, 3};
    const GridInterval grid = gridInterval(values, 4);
    EXPECT_DOUBLE_EQ(grid.mean.value, 3.75);
    EXPECT_EQ(grid.mean.ci95, 0.0);
    EXPECT_DOUBLE_EQ(grid.minimum.value, 3.0);
    EXPECT_EQ(grid.minimum.ci95, 0.0);
    EXPECT_DOUBLE_EQ(grid.uniformity.value, 0.8);
    EXPECT_EQ(grid.uniformity.ci95, 0.0);
    EXPECT_EQ(grid.minimumPoint, 1u);
}

TEST(GridInterval, OneExactPointAmongNoisyOnes) {
    std::vector<double> values = noisyGrid(8, 16, 0.0);
    std::fill_n(values.begin() + 32, 16, 100.0);  // 80 standard errors below
    const GridInterval grid = gridInterval(values, 8);
    EXPECT_EQ(grid.minimumPoint, 2u);
    EXPECT_DOUBLE_EQ(grid.minimum.value, 100.0);
    EXPECT_EQ(grid.minimum.ci95, 0.0);
}

TEST(GridInterval, DarkGridHasNoUniformity) {
    const GridInterval grid = gridInterval(std::vector<double>(12, 0.0), 4);
    EXPECT_EQ(grid.mean.value, 0.0);
    EXPECT_EQ(grid.minimum.ci95, 0.0);
    EXPECT_EQ(grid.uniformity.relative(), std::numeric_limits<double>::infinity());
}

TEST(GridInterval, ScalesWithTheUnit) {
    std::vector<double> values = noisyGrid(20, 16, 1.0);
    const GridInterval lux = gridInterval(values, 20);
    for (double& x : values) x *= 1024.0;  // a power of two: no rounding, so the same bits
    const GridInterval scaled = gridInterval(values, 20);
    EXPECT_EQ(scaled.minimum.value, 1024.0 * lux.minimum.value);
    EXPECT_EQ(scaled.minimum.ci95, 1024.0 * lux.minimum.ci95);
    EXPECT_EQ(scaled.uniformity.value, lux.uniformity.value);
    EXPECT_EQ(scaled.uniformity.ci95, lux.uniformity.ci95);
    EXPECT_EQ(scaled.minimumPoint, lux.minimumPoint);
}

TEST(GridInterval, TenThousandPointsAllInContention) {
    const GridInterval grid = gridInterval(noisyGrid(10'000, 32, 0.0), 10'000);
    // Truth 300 everywhere, an error of 1.77 a point: the smallest of 10,000 lies 3.85 of them low, 6.8 lx,
    // more than a half-width of 2.04 x 1.77. Only the correction brings the truth into the interval.
    EXPECT_NEAR(grid.minimum.value, 300.0, grid.minimum.ci95);
    EXPECT_LT(grid.minimum.ci95, 6.8);
    // Five of the mean's own standard errors: false alarm 6e-7.
    EXPECT_NEAR(grid.mean.value, 300.0, 5.0 * 0.0177);
}

}  // namespace
}  // namespace luxdeck
