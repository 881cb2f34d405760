// Noise: a function of the place alone, smooth between lattice points.
#include "engine/io/cal_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace luxdeck::cal {
namespace {

TEST(CalNoise, IsDeterministicAndWithinItsRange) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-50, 50);
    double sum = 0, sumOfSquares = 0;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
        const double x = place(random), y = place(random), z = place(random);
        const double n = noise3(x, y, z, 3);
        EXPECT_EQ(n, noise3(x, y, z, 3));
        // Values of -1..1 between neighbours, and gradients of -1..1 that add 4/27 at most along each axis, twice.
        EXPECT_LE(std::abs(n), 1 + 6 * 4.0 / 27);
        for (int k = 0; k < 3; ++k) EXPECT_LE(std::abs(noise3(x, y, z, k)), 1);
        EXPECT_LE(std::abs(fractalNoise3(x, y, z)), 2);  // -1..1, and displacements of 1/2 + 1/4 + ...
        sum += n, sumOfSquares += n * n;
    }
    // Lattice values are uniform on -1..1: the mean is 0 and the variance between 0.1 and 1/3, over 10^6 cells; six
    // standard errors of 20,000 values of deviation < 0.6 are 0.025 (false alarm < 1e-8 if places were drawn anew).
    EXPECT_LT(std::abs(sum / kCount), 0.025);
    EXPECT_GT(sumOfSquares / kCount, 0.05);
    EXPECT_LT(sumOfSquares / kCount, 1.0 / 3);
}

TEST(CalNoise, IsSmoothAcrossLatticePlanesWithTheGradientThatItNames) {
    for (int i = -3; i <= 3; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            constexpr double h = 1e-6;
            const double at[3] = {double(i), 2.0 * i + 1, 5.0 - i};
            const auto shifted = [&](double by) {
                double p[3] = {at[0], at[1], at[2]};
                p[axis] += by;
                return noise3(p[0], p[1], p[2], 3);
            };
            const double centre = shifted(0), slope = noise3(at[0], at[1], at[2], axis);
            // Second derivatives are below 20: h of 1e-6 leaves 1e-5 in a slope, roundings 1e-10.
            EXPECT_NEAR((shifted(h) - centre) / h, slope, 5e-5);
            EXPECT_NEAR((centre - shifted(-h)) / h, slope, 5e-5);
        }
}

TEST(CalNoise, OfTheFractalKindIsContinuousToItsResolution) {
    // Cubes of 1000, 500, 250 and 125 parts of a cell tile it, so both sides of a face share their corners; 125 is
    // odd, and the displacements of what is finer, 62, 31, 15, 7, 3 and 1 thousandths, differ by twice their sum.
    for (int i = 0; i < 200; ++i) {
        const double y = 0.013 * i, z = 1.7 - 0.011 * i;
        EXPECT_NEAR(fractalNoise3(2.0 - 1e-9, y, z), fractalNoise3(2.0, y, z), 0.238);
    }
    EXPECT_TRUE(std::isnan(fractalNoise3(std::nan(""), 0, 0)));
    EXPECT_TRUE(std::isnan(noise3(0, INFINITY, 0, 3)));
}

TEST(CalNoise, RandomNumbersFillTheUnitInterval) {
    int low = 0;
    for (int i = 0; i < 10000; ++i) {
        const double r = randomOf(i * 0.37);
        ASSERT_GE(r, 0);
        ASSERT_LT(r, 1);
        low += r < 0.5 ? 1 : 0;
    }
    EXPECT_NEAR(low, 5000, 400);  // 8 standard deviations of 50 of a fair coin; fixed inputs, so it cannot flicker
}

}  // namespace
}  // namespace luxdeck::cal
