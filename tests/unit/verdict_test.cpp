#include "analysis/grids/solve_result.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace luxdeck {
namespace {

TEST(Verdict, FollowsTheWholeInterval) {
    EXPECT_EQ(judge({520, 10}, 500), Verdict::Met);
    EXPECT_EQ(judge({510, 10}, 500), Verdict::Met) << "the limit itself is enough";
    EXPECT_EQ(judge({509, 10}, 500), Verdict::Undecided);
    EXPECT_EQ(judge({491, 10}, 500), Verdict::Undecided);
    EXPECT_EQ(judge({490, 10}, 500), Verdict::Undecided) << "its upper end meets the limit";
    EXPECT_EQ(judge({489, 10}, 500), Verdict::NotMet);
}

TEST(Verdict, ExactValuesAreNeverUndecided) {
    EXPECT_EQ(judge({500, 0}, 500), Verdict::Met);
    EXPECT_EQ(judge({499.999, 0}, 500), Verdict::NotMet);
    EXPECT_EQ(judge({0, 0}, 500), Verdict::NotMet);
    EXPECT_EQ(judge({0, 0}, 0), Verdict::Met);
}

TEST(Verdict, WhatIsNotKnownIsUndecided) {
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(judge({1000, infinity}, 500), Verdict::Undecided);
    EXPECT_EQ(judge({0, infinity}, 500), Verdict::Undecided);
    EXPECT_EQ(judge({nan, 1}, 500), Verdict::Undecided);
}

TEST(Verdict, WithoutARequirementThereIsNone) {
    EXPECT_EQ(judge({520, 10}, std::nullopt), Verdict::None);
    EXPECT_EQ(verdictText(Verdict::None), std::string());
    EXPECT_EQ(verdictText(Verdict::Met), std::string("met"));
    EXPECT_EQ(verdictText(Verdict::NotMet), std::string("not met"));
    EXPECT_EQ(verdictText(Verdict::Undecided), std::string("undecided"));
}

}  // namespace
}  // namespace luxdeck
