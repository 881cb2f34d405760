#include "gui/session/gizmo_motion.h"

#include <cmath>

namespace luxdeck::gui {

namespace {

constexpr double kEdgeOn = 0.02;   // sine of the angle below which a plane or axis is seen from its edge

double snapped(double value, double step) { return step > 0 ? std::round(value / step) * step : value; }

/// Where a line of sight goes through the level at the centre's height, seen from it.
std::optional<Vec3d> onLevel(const Vec3d& centre, const SightLine& line) {
    if (std::abs(line.direction.z) < kEdgeOn) return {};
    const double distance = (centre.z - line.origin.z) / line.direction.z;
    if (distance < 0) return {};
    return line.origin + line.direction * distance - centre;
}

/// How far along an axis a line of sight passes nearest.
std::optional<double> alongAxis(const Vec3d& centre, const Vec3d& axis, const SightLine& line) {
    const double b = axis.dot(line.direction), sine2 = 1 - b * b;
    if (sine2 < kEdgeOn * kEdgeOn) return {};
    const Vec3d w = centre - line.origin;
    return (b * line.direction.dot(w) - axis.dot(w)) / sine2;
}

std::optional<GizmoMotion> alongBy(const Vec3d& axis, const Vec3d& centre, const SightLine& from, const SightLine& to, double step) {
    const auto start = alongAxis(centre, axis, from), end = alongAxis(centre, axis, to);
    if (!start || !end) return {};
    return GizmoMotion{axis * snapped(*end - *start, step), 0};
}

}  // namespace

std::optional<GizmoMotion> draggedBy(Handle handle, const Vec3d& centre, const SightLine& from, const SightLine& to, const Snapping& snapping) {
    switch (handle) {
        case Handle::X: return alongBy({1, 0, 0}, centre, from, to, snapping.stepM);
        case Handle::Y: return alongBy({0, 1, 0}, centre, from, to, snapping.stepM);
        case Handle::Z: return alongBy({0, 0, 1}, centre, from, to, snapping.stepM);
        case Handle::None: return {};
        default: break;
    }
    const auto start = onLevel(centre, from), end = onLevel(centre, to);
    if (!start || !end) return {};
    if (handle == Handle::Plan) return GizmoMotion{{snapped(end->x - start->x, snapping.stepM), snapped(end->y - start->y, snapping.stepM), 0}, 0};
    const double turn = (std::atan2(end->y, end->x) - std::atan2(start->y, start->x)) / kDegree;
    return GizmoMotion{{0, 0, 0}, snapped(std::remainder(turn, 360), snapping.stepDeg)};
}

}  // namespace luxdeck::gui
