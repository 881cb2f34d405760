#include "tonemap/isolines.h"
#include "engine/core/rng.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace luxdeck::tonemap {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Isolines, ACircleIsOneClosedLine) {
    constexpr int kSize = 41;
    std::vector<double> values;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) values.push_back(std::hypot(x - 20, y - 20));
    const auto lines = isolines(values, kSize, kSize, std::vector<double>{12.3});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].closed);
    EXPECT_EQ(lines[0].level, 12.3);
    for (const auto& p : lines[0].points)  // linear interpolation of a distance along a unit edge: curvature / 8
        EXPECT_NEAR(std::hypot(p[0] - 20, p[1] - 20), 12.3, 1.0 / (8 * 12));
    // Higher values, here outside, are on the right hand: seen with rows downwards the line runs the other way.
    double area = 0;
    for (std::size_t i = 0; i < lines[0].points.size(); ++i) {
        const auto &p = lines[0].points[i], &q = lines[0].points[(i + 1) % lines[0].points.size()];
        area += 0.5 * (p[0] * q[1] - q[0] * p[1]);
    }
    EXPECT_NEAR(-area, 3.14159 * 12.3 * 12.3, 5);  // chords of about a unit inside a radius of 12: 1 %
}

TEST(Isolines, ASlopeIsOneOpenLine) {
    std::vector<double> values;
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 8; ++x) values.push_back(x);
    const auto lines = isolines(values, 8, 5, std::vector<double>{2.5, 6.25, 99});
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_FALSE(lines[0].closed);
    EXPECT_EQ(lines[0].points.size(), 5U);
    for (const auto& p : lines[1].points) EXPECT_NEAR(p[0], 6.25, 1e-12);
}

TEST(Isolines, SaddlesAreDecidedByTheMean) {
    const std::vector<double> high{2, 0, 0.5, 2}, low{1.2, -4, -4, 1.2};
    for (const auto& values : {high, low}) EXPECT_EQ(isolines(values, 2, 2, std::vector<double>{1}).size(), 2U);
    // Mean above: the low corners are cut off, so the first line ends on the right edge, not on the left.
    const auto cutLow = isolines(high, 2, 2, std::vector<double>{1});
    EXPECT_EQ(cutLow[0].points.back()[0], 1);
    const auto cutHigh = isolines(low, 2, 2, std::vector<double>{1});
    EXPECT_EQ(cutHigh[0].points.back()[0], 0);
}

TEST(Isolines, HolesOfNaNAreLeftOut) {
    std::vector<double> values;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) values.push_back(x == 4 && y == 4 ? kNaN : x);
    const auto lines = isolines(values, 9, 9, std::vector<double>{3.5});
    EXPECT_EQ(lines.size(), 2U);  // above and below the hole
    for (const auto& line : lines)
        for (const auto& p : line.points) EXPECT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]));
}

TEST(Isolines, EveryCrossedEdgeIsOnExactlyOneLine) {
    constexpr int kColumns = 30, kRows = 20;
    RandomStream random(9);
    std::vector<double> values;
    for (int i = 0; i < kColumns * kRows; ++i)
        values.push_back(std::floor(random.uniform() * 5));  // many equal to a level
    const double level = 2.5;
    std::size_t crossed = 0, points = 0;
    for (int y = 0; y < kRows; ++y)
        for (int x = 0; x < kColumns; ++x) {
            const bool above = values[static_cast<std::size_t>(y * kColumns + x)] >= level;
            if (x + 1 < kColumns) crossed += above != (values[static_cast<std::size_t>(y * kColumns + x + 1)] >= level);
            if (y + 1 < kRows) crossed += above != (values[static_cast<std::size_t>((y + 1) * kColumns + x)] >= level);
        }
    for (const auto& line : isolines(values, kColumns, kRows, std::vector<double>{level})) points += line.points.size();
    EXPECT_EQ(points, crossed);
}

TEST(Isolines, NothingToDraw) {
    EXPECT_TRUE(isolines(std::vector<double>(9, 1.0), 3, 3, std::vector<double>{1, 2}).empty());
    EXPECT_TRUE(isolines(std::vector<double>{1, 2}, 2, 1, std::vector<double>{1.5}).empty());
    EXPECT_TRUE(isolines(std::vector<double>{}, 0, 0, std::vector<double>{1.5}).empty());
    EXPECT_TRUE(isolines(std::vector<double>{1, 2, 3}, 2, 2, std::vector<double>{1.5}).empty());
}

TEST(RoundLevels, AreRound) {
    EXPECT_EQ(roundLevels(0, 1000, 5, false), (std::vector<double>{0, 200, 400, 600, 800, 1000}));
    const auto fine = roundLevels(1, 100, 8, true);
    const std::vector<double> expected{1, 2, 5, 10, 20, 50, 100};
    ASSERT_EQ(fine.size(), expected.size());
    for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_NEAR(fine[i], expected[i], 1e-12 * expected[i]);
    EXPECT_EQ(roundLevels(1e-3, 1e5, 5, true).size(), 4U);  // every other decade
    EXPECT_TRUE(roundLevels(5, 5, 5, false).empty());
    EXPECT_TRUE(roundLevels(0, 5, 5, true).empty());
    EXPECT_TRUE(roundLevels(0, kNaN, 5, false).empty());
    EXPECT_FALSE(std::signbit(roundLevels(0, 10, 5, false)[0]));
}

}  // namespace
}  // namespace luxdeck::tonemap
