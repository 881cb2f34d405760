#include "analysis/grids/condition.h"

#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luxdeck::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A point whose replicates have these direct means in turn.
PointSums point(double even, double odd) {
    PointSums sums;
    sums.perReplicate = 2;
    for (std::size_t r = 0; r < kReplicates; ++r) sums.direct[r] = 2 * (r % 2 == 0 ? even : odd);
    return sums;
}

TEST(Condition, CountsReplicatesThatCarryTheValue) {
    const auto effective = [](const std::vector<PointSums>& sums) { return conditionOf(Scene{}, sums).effectiveReplicates; };
    EXPECT_DOUBLE_EQ(effective({point(100, 100)}), kReplicates);
    EXPECT_DOUBLE_EQ(effective({point(100, 0)}), kReplicates / 2.0);
    EXPECT_DOUBLE_EQ(effective({point(100, 100), point(100, 0)}), kReplicates / 2.0) << "the worst point counts";
    auto one = point(0, 0);
    one.direct[5] = 3200;
    EXPECT_DOUBLE_EQ(effective({one}), 1);
    EXPECT_DOUBLE_EQ(effective({point(1000, 1000), point(2, 0)}), kReplicates) << "a dark point is of no account";
    EXPECT_DOUBLE_EQ(effective({point(0, 0)}), kReplicates) << "darkness is certain";
    EXPECT_DOUBLE_EQ(effective({PointSums{}}), kReplicates) << "nothing was sampled";
}

TEST(Condition, WarnsOfWhatIsBad) {
    const auto good = conditionOf(cubeRoom(0.5F, 1000), {point(100, 101)});
    EXPECT_NEAR(good.amplification, 2, 1e-6);  // float's 0.5 is exact; areas sum in double
    EXPECT_THAT(conditionWarnings(good, 0), IsEmpty());
    const auto white = conditionOf(cubeRoom(0.98F, 1000), {point(100, 101)});
    EXPECT_THAT(conditionWarnings(white, 0), ElementsAre(HasSubstr("98.0 % on average")));
    EXPECT_THAT(conditionWarnings(good, 0.01), ElementsAre(HasSubstr("1 % of the light")));
    const auto noisy = conditionOf(cubeRoom(0.5F, 1000), {point(100, 0), point(3, 100)});
    EXPECT_THAT(conditionWarnings(noisy, 0), IsEmpty()) << "half is the limit";
    auto rare = point(0, 0);
    rare.direct[0] = 100;
    EXPECT_THAT(conditionWarnings(conditionOf(cubeRoom(0.5F, 1000), {rare}), 0), ElementsAre(HasSubstr("1.0 of 32")));
}

}  // namespace
}  // namespace luxdeck::test
