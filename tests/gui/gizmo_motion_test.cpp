// Handles of selected things: how far a drag on the screen goes in the room.
#include "gui/session/gizmo_motion.h"

#include <gtest/gtest.h>

namespace luxdeck::gui {
namespace {

const Vec3d kCentre{2, 3, 0.5};

/// A line of sight from above through a point.
SightLine through(const Vec3d& point) {
    const Vec3d eye(-4, -6, 5);
    return {eye, (point - eye).normalized()};
}

GizmoMotion drag(Handle handle, const Vec3d& from, const Vec3d& to, const Snapping& snapping = Snapping::off()) {
    return draggedBy(handle, kCentre, through(kCentre + from), through(kCentre + to), snapping).value();
}

TEST(GizmoMotion, FollowsAxesAndThePlan) {
    EXPECT_LT((drag(Handle::X, {0.5, 0, 0}, {1.73, 0, 0}).moveM - Vec3d(1.23, 0, 0)).length(), 1e-9);
    EXPECT_LT((drag(Handle::Y, {0, 0.5, 0}, {0, -0.4, 0}).moveM - Vec3d(0, -0.9, 0)).length(), 1e-9);
    EXPECT_LT((drag(Handle::Z, {0, 0, 0.5}, {0, 0, 1.6}).moveM - Vec3d(0, 0, 1.1)).length(), 1e-9);
    EXPECT_LT((drag(Handle::Plan, {0.2, 0.2, 0}, {-1, 0.7, 0}).moveM - Vec3d(-1.2, 0.5, 0)).length(), 1e-9);
    EXPECT_EQ(drag(Handle::Plan, {0.2, 0.2, 0}, {-1, 0.7, 0}).turnDeg, 0);
}

TEST(GizmoMotion, TurnsCounterClockwiseAsSeenFromAboveAndTheShortWay) {
    EXPECT_NEAR(drag(Handle::Turn, {1, 0, 0}, {0, 2, 0}).turnDeg, 90, 1e-9);
    EXPECT_NEAR(drag(Handle::Turn, {-1, 0.1, 0}, {-1, -0.1, 0}).turnDeg, 2 * std::atan(0.1) / kDegree, 1e-9);
}

TEST(GizmoMotion, SnapsToSteps) {
    EXPECT_LT((drag(Handle::X, {0, 0, 0}, {0.56, 0, 0}, {}).moveM - Vec3d(0.6, 0, 0)).length(), 1e-12);
    EXPECT_LT((drag(Handle::X, {0, 0, 0}, {0.564, 0, 0}, Snapping::fine()).moveM - Vec3d(0.56, 0, 0)).length(), 1e-12);
    EXPECT_NEAR(drag(Handle::Turn, {1, 0, 0}, {1, 0.7, 0}, {}).turnDeg, 30, 1e-12);
}

TEST(GizmoMotion, SaysNothingWhereTheLinesDoNotTell) {
    const SightLine level{{-5, 0, 0.5}, {1, 0, 0}};
    EXPECT_FALSE(draggedBy(Handle::Plan, kCentre, level, level, {}));
    EXPECT_FALSE(draggedBy(Handle::X, kCentre, level, level, {}));
    EXPECT_FALSE(draggedBy(Handle::None, kCentre, through(kCentre), through(kCentre), {}));
}

}  // namespace
}  // namespace luxdeck::gui
