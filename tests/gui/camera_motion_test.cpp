// How views move: what is under the cursor stays there.
#include "gui/session/camera_motion.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace luxdeck::gui {
namespace {

constexpr double kAspect = 1.6;
constexpr double kStays = 1e-6;  // of half a screen

struct Situation {
    CameraPose pose;
    ScreenPoint cursor;
    Vec3d under;  // the cursor
};

/// Cameras that look about from anywhere, with and without perspective, and a point under a cursor.
std::vector<Situation> situations() {
    std::mt19937 dice(7);
    std::uniform_real_distribution<double> u(-1, 1);
    std::vector<Situation> out;
    for (int i = 0; i < 200; ++i) {
        auto pose = lookedAround(CameraPose{}, 180 * u(dice), 80 * u(dice));
        pose.position = Vec3d(10 * u(dice), 10 * u(dice), 3 * u(dice));
        pose.fovDeg = 50 + 30 * u(dice);
        pose.parallel = i % 4 == 0;
        const ScreenPoint cursor{u(dice), u(dice)};
        const auto line = sightLine(pose, kAspect, cursor);
        out.push_back({pose, cursor, line.origin + line.direction * (5 + 4 * u(dice))});
    }
    return out;
}

void expectSeenAt(const CameraPose& pose, const Vec3d& point, ScreenPoint at) {
    const auto seen = seenAt(pose, kAspect, point);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->x, at.x, kStays);
    EXPECT_NEAR(seen->y, at.y, kStays);
}

void expectUpright(const CameraPose& pose) {
    EXPECT_NEAR(pose.direction.length(), 1, 1e-9);
    EXPECT_NEAR(pose.up.length(), 1, 1e-9);
    EXPECT_NEAR(pose.up.dot(pose.direction), 0, 1e-9);
    EXPECT_NEAR(pose.right().z, 0, 1e-9);
    EXPECT_GE(pose.up.z, 0);
}

TEST(CameraMotion, SightLinesLeadToWhereTheyAreSeen) {
    for (const auto& s : situations()) expectSeenAt(s.pose, s.under, s.cursor);
}

TEST(CameraMotion, ApproachingGoesTenPercentCloserAndThePointStays) {
    for (const auto& s : situations()) {
        const auto closer = approached(s.pose, kAspect, s.under, 0.9);
        expectSeenAt(closer, s.under, s.cursor);
        EXPECT_EQ(closer.direction, s.pose.direction);
        if (s.pose.parallel)
            EXPECT_NEAR(closer.heightM, 0.9 * s.pose.heightM, 1e-9);
        else
            EXPECT_NEAR((closer.position - s.under).length(), 0.9 * (s.pose.position - s.under).length(), 1e-9);
        const auto back = approached(closer, kAspect, s.under, 1 / 0.9);
        EXPECT_NEAR((back.position - s.pose.position).length(), 0, 1e-9);
    }
}

TEST(CameraMotion, ApproachingNeverPassesThePoint) {
    for (const auto& s : situations()) {
        auto pose = s.pose;
        for (int i = 0; i < 500; ++i) pose = approached(pose, kAspect, s.under, 0.9);
        expectSeenAt(pose, s.under, s.cursor);
    }
}

TEST(CameraMotion, OrbitingKeepsThePointAndItsDistance) {
    for (const auto& s : situations()) {
        const auto around = orbited(s.pose, s.under, 33, -12);
        expectSeenAt(around, s.under, s.cursor);
        expectUpright(around);
        EXPECT_NEAR((around.position - s.under).length(), (s.pose.position - s.under).length(), 1e-9);
    }
}

TEST(CameraMotion, PanningBringsThePointToTheCursor) {
    for (const auto& s : situations()) {
        const ScreenPoint to{0.3, -0.7};
        const auto shifted = panned(s.pose, kAspect, s.under, to);
        expectSeenAt(shifted, s.under, to);
        EXPECT_EQ(shifted.direction, s.pose.direction);
        EXPECT_NEAR(depthOf(shifted, s.under), depthOf(s.pose, s.under), 1e-9);
    }
}

TEST(CameraMotion, LookingAroundStaysInPlaceAndNeverOverturns) {
    CameraPose pose;
    for (int i = 0; i < 50; ++i) pose = lookedAround(pose, 0, 7);
    expectUpright(pose);
    EXPECT_GT(pose.direction.z, std::sin(88.9 * kDegree));
    EXPECT_EQ(pose.position, CameraPose{}.position);
    // From a plan, which looks straight down, tilting up leads out of it.
    const auto plan = lookingFrom(Side::Top, kAspect, Box3({0, 0, 0}, {4, 3, 2}));
    EXPECT_NEAR(lookedAround(plan, 0, 30).direction.z, -std::cos(30 * kDegree), 1e-9);
}

TEST(CameraMotion, WalkingStaysLevel) {
    const auto pose = lookedAround(CameraPose{}, -90, -40);  // towards +x, down
    const auto ahead = walked(pose, 2, 0, 0), aside = walked(pose, 0, 1, 0), higher = walked(pose, 0, 0, 0.5);
    EXPECT_NEAR((ahead.position - pose.position - Vec3d(2, 0, 0)).length(), 0, 1e-9);
    EXPECT_NEAR((aside.position - pose.position - Vec3d(0, -1, 0)).length(), 0, 1e-9);
    EXPECT_NEAR((higher.position - pose.position - Vec3d(0, 0, 0.5)).length(), 0, 1e-9);
}

TEST(CameraMotion, FittingShowsTheWholeBoxAndFillsTheView) {
    const Box3 box({-2, 1, 0}, {12, 10, 3});
    for (const auto& s : situations()) {
        const auto fit = fitted(s.pose, kAspect, box);
        double most = 0;
        for (int i = 0; i < 8; ++i) {
            const auto seen = seenAt(fit, kAspect, {i & 1 ? 12.0 : -2.0, i & 2 ? 10.0 : 1.0, i & 4 ? 3.0 : 0.0});
            ASSERT_TRUE(seen);
            most = std::max({most, std::abs(seen->x), std::abs(seen->y)});
        }
        EXPECT_LT(most, 1);
        EXPECT_GT(most, 0.85);
    }
}

TEST(CameraMotion, SidesLookWhereTheyShould) {
    const Box3 box({0, 0, 0}, {4, 3, 2});
    const auto direction = [&](Side side) { return lookingFrom(side, kAspect, box).direction; };
    EXPECT_EQ(direction(Side::Top), Vec3d(0, 0, -1));
    EXPECT_EQ(direction(Side::Front), Vec3d(0, 1, 0));
    EXPECT_EQ(direction(Side::Left), Vec3d(1, 0, 0));
    EXPECT_EQ(lookingFrom(Side::Top, kAspect, box).up, Vec3d(0, 1, 0));
    EXPECT_FALSE(lookingFrom(Side::Iso, kAspect, box).parallel);
    EXPECT_LT(direction(Side::Iso).z, -0.4);
}

TEST(CameraMotion, AViewComesBackAsItWas) {
    Scene scene;
    scene.origin = {1000, 2000, 30};
    View view;
    view.position = {1003, 2004, 31.7};
    view.direction = Vec3d(1, 2, -0.3).normalized();
    view.verticalFovDeg = 56;
    const auto again = viewOf(poseOf(view, scene), scene, "here", 1500, 1000);
    EXPECT_LT((again.position - view.position).length(), 1e-5);
    EXPECT_LT((again.direction - view.direction).length(), 1e-12);
    EXPECT_EQ(again.verticalFovDeg, 56);
    EXPECT_EQ(again.width, 1500);
}

}  // namespace
}  // namespace luxdeck::gui
