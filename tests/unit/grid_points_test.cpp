#include "analysis/grids/grid_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace luxdeck {
namespace {

CalculationGrid grid(double u, double v) {
    CalculationGrid g;
    g.name = "Desk";
    g.where = "project.toml:7";
    g.origin = {1, 2, 0.75};
    g.u = {u, 0, 0}, g.v = {0, v, 0};
    return g;
}

GridLayout laidOut(const CalculationGrid& g) {
    auto layout = layOut(g);
    EXPECT_TRUE(layout) << layout.error().text();
    return layout ? *layout : GridLayout{};
}

// EN 12464-1:2021, table of grid spacings, rounded there to two or three digits: half a unit of the last.
TEST(GridSpacing, IsThatOfTheStandardsTable) {
    const double table[][3] = {{0.4, 0.105, 0.0005}, {1, 0.2, 0.0005}, {2, 0.325, 0.0005}, {5, 0.616, 0.0015},
                               {10, 1.0, 0.005}, {25, 1.90, 0.005}, {50, 3.08, 0.005}, {100, 5.0, 0.005}};
    for (const auto& [d, p, half] : table) EXPECT_NEAR(gridSpacingM(d), p, half) << d;
    EXPECT_EQ(gridSpacingM(1000), 10.0) << "0.2 * 5^3 = 25 m is cut off";
    EXPECT_NEAR(gridSpacingM(0.4), 0.2 * std::pow(5, std::log10(0.4)), 1e-12);
}

TEST(GridLayout, PointsSitInTheCentresOfCells) {
    auto g = grid(4, 3);
    g.counts = {{4, 3}};
    const auto layout = laidOut(g);
    ASSERT_EQ(layout.points.size(), 12U);
    EXPECT_EQ(layout.points[0], Vec3d(1.5, 2.5, 0.75));
    EXPECT_EQ(layout.points[1], Vec3d(2.5, 2.5, 0.75)) << "columns run along u";
    EXPECT_EQ(layout.points[11], Vec3d(4.5, 4.5, 0.75));
    for (const auto& n : layout.normals) EXPECT_EQ(n, Vec3d(0, 0, 1));
}

TEST(GridLayout, NoCellIsLongerThanTheSpacing) {
    for (const double u : {0.3, 1.0, 2.5, 7.0, 30.0})
        for (const double v : {0.3, 1.0, 2.5, 7.0, 30.0}) {
            const auto layout = laidOut(grid(u, v));
            const double longer = std::max(u, v), shorter = std::min(u, v), p = gridSpacingM(longer >= 2 * shorter ? shorter : longer);
            for (const auto& [length, cells] : {std::pair{u, layout.columns}, std::pair{v, layout.rows}}) {
                EXPECT_LE(length / cells, p * (1 + 1e-9)) << u << " x " << v;  // the slack for whole multiples
                EXPECT_TRUE(cells == 1 || length / (cells - 1) > p * (1 - 1e-9)) << u << " x " << v << ": a cell too many";
            }
            EXPECT_EQ(layout.points.size(), static_cast<std::size_t>(layout.columns) * static_cast<std::size_t>(layout.rows));
        }
}

// EN 12464-1, 4.4: where the longer side is twice the shorter or more, d is the shorter.
TEST(GridLayout, LongSurfacesGoByTheirShorterSide) {
    const auto layout = laidOut(grid(10, 2));
    EXPECT_EQ(layout.rows, static_cast<int>(std::ceil(2 / gridSpacingM(2))));
    EXPECT_EQ(layout.columns, static_cast<int>(std::ceil(10 / gridSpacingM(2))));
    EXPECT_EQ(laidOut(grid(10, 5)).rows, static_cast<int>(std::ceil(5 / gridSpacingM(5)))) << "exactly twice counts as long";
    EXPECT_EQ(laidOut(grid(10, 5.01)).rows, static_cast<int>(std::ceil(5.01 / gridSpacingM(10))));
}

TEST(GridLayout, TheBorderIsTakenOffFirst) {
    auto g = grid(5, 4);
    g.borderM = 0.5, g.counts = {{2, 3}};
    const auto layout = laidOut(g);
    EXPECT_EQ(layout.origin, Vec3d(1.5, 2.5, 0.75));
    EXPECT_EQ(layout.u, Vec3d(4, 0, 0));
    EXPECT_EQ(layout.v, Vec3d(0, 3, 0));
    EXPECT_EQ(layout.points[0], Vec3d(2.5, 3, 0.75));
    g.counts.reset();
    EXPECT_EQ(laidOut(g).columns, static_cast<int>(std::ceil(4 / gridSpacingM(4)))) << "spacing by what is left";
    g.borderM = 2;
    const auto nothing = layOut(g);
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error().text(), "project.toml:7: grid \"Desk\": a border of 2 m leaves nothing of 5 x 4 m");
}

TEST(GridLayout, SpacingGivenByHandRoundsToNoExtraCell) {
    auto g = grid(1.2, 0.9);
    g.spacingM = 0.3;  // 1.2 / 0.3 is 4.000000000000001 in doubles
    const auto layout = laidOut(g);
    EXPECT_EQ(layout.columns, 4);
    EXPECT_EQ(layout.rows, 3);
    g.spacingM = 5;
    EXPECT_EQ(laidOut(g).points.size(), 1U);
}

TEST(GridLayout, SlantedSurfacesKeepTheirPlane) {
    auto g = grid(0, 0);
    g.u = {0, 2, 0}, g.v = {0, 0.5, 1};
    const auto layout = laidOut(g);
    const Vec3d n = g.u.cross(g.v).normalized();
    for (std::size_t i = 0; i < layout.points.size(); ++i) {
        EXPECT_NEAR((layout.points[i] - g.origin).dot(n), 0, 1e-12);  // double rounding at 3 m
        EXPECT_LT((layout.normals[i] - n).length(), 1e-15);
    }
}

TEST(GridLayout, CylindersStandUpright) {
    auto g = grid(2, 2);
    g.kind = GridKind::Cylindrical, g.u = {0, 0, 2};
    for (const auto& n : laidOut(g).normals) EXPECT_EQ(n, Vec3d(0, 0, 1));
}

TEST(GridLayout, FreePointsStandForThemselves) {
    auto g = grid(1, 1);
    g.points = {{{{5, 6, 7}, {0, 0, -2}}}, {{{1, 1, 1}, {3, 0, 4}}}};
    const auto layout = laidOut(g);
    EXPECT_EQ(layout.columns, 0);
    ASSERT_EQ(layout.points.size(), 2U);
    EXPECT_EQ(layout.points[0], Vec3d(5, 6, 7));
    EXPECT_EQ(layout.normals[0], Vec3d(0, 0, -1));
    EXPECT_LT((layout.normals[1] - Vec3d(0.6, 0, 0.8)).length(), 1e-15);
}

TEST(GridLayout, AMillionPointsAreEnough) {
    auto g = grid(10, 10);
    g.spacingM = 0.005;
    const auto refused = layOut(g);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::InvalidArgument);
    EXPECT_THAT(refused.error().message, ::testing::HasSubstr("2000 x 2000 points, expected at most a million"));
    g.spacingM = 1e-300;  // no overflow on the way
    EXPECT_FALSE(layOut(g));
}

}  // namespace
}  // namespace luxdeck
