#include "engine/core/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace luxdeck::test {
namespace {

constexpr std::size_t kReplicateCount = 32;

TEST(SkewedInterval, IsStudentsWithoutSkewness) {
    const auto interval = skewedInterval(10, 2, 0, 31);
    EXPECT_EQ(interval.below(), interval.above());
    EXPECT_NEAR(interval.ci95, 2 * studentT95(31), 1e-9);
}

TEST(SkewedInterval, ReachesFartherToTheSideOfTheTail) {
    const auto right = skewedInterval(10, 2, 0.5, 31), left = skewedInterval(10, 2, -0.5, 31);
    EXPECT_GT(right.above(), right.below());
    EXPECT_EQ(right.ci95, right.above());
    EXPECT_NEAR(right.above(), left.below(), 1e-9);
    EXPECT_NEAR(right.below(), left.above(), 1e-9);
}

TEST(SkewedInterval, KeepsItsSidesWhenWidened) {
    const auto interval = Interval::sides(5, 1, 2).widenedAbove(3);
    EXPECT_EQ(interval.low(), 4);
    EXPECT_EQ(interval.high(), 10);
    EXPECT_EQ(interval.ci95, 5);
}

/// Part of 4,000 trials in which the interval holds the mean of rare events of random size, `expected` of them in all.
template <class Size>
double coverage(double expected, Size size) {
    std::mt19937_64 random(7);
    std::poisson_distribution<int> count(expected / kReplicateCount);
    int held = 0;
    constexpr int kTrials = 4000;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::array<double, kReplicateCount> means{};
        for (auto& mean : means)
            for (int i = count(random); i > 0; --i) mean += size(random);
        const auto interval = meanOfReplicates(means);
        const double truth = expected / kReplicateCount;
        held += truth >= interval.low() && truth <= interval.high() ? 1 : 0;
    }
    return 100.0 * held / kTrials;
}

// The standard error of 4,000 trials at 95 % is 0.34 %: 93 and 97.5 % are more than five of them from what decision 12
// found (95.0 to 96.0 %), so that a false alarm has a chance below 1e-6. Seeds are fixed.
TEST(SkewedInterval, HoldsRareEventsOfOneSize) {
    for (const double expected : {20.0, 50.0, 300.0}) {
        const double percent = coverage(expected, [](auto&) { return 1.0; });
        EXPECT_GE(percent, 93) << expected;
        EXPECT_LE(percent, 97.5) << expected;
    }
}

TEST(SkewedInterval, HoldsRareEventsOfExponentialSizes) {
    for (const double expected : {20.0, 50.0, 300.0}) {
        const double percent = coverage(expected, [](auto& random) { return std::exponential_distribution<double>(1.0)(random); });
        EXPECT_GE(percent, 93) << expected;
        EXPECT_LE(percent, 97.5) << expected;
    }
}

TEST(SkewedInterval, HoldsNormalReplicates) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> noise(100, 5);
    int held = 0;
    constexpr int kTrials = 4000;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::array<double, kReplicateCount> means{};
        for (auto& mean : means) mean = noise(random);
        const auto interval = meanOfReplicates(means);
        held += interval.low() <= 100 && 100 <= interval.high() ? 1 : 0;
    }
    EXPECT_NEAR(100.0 * held / kTrials, 95, 1.5);  // more than four standard errors
}

}  // namespace
}  // namespace luxdeck::test
