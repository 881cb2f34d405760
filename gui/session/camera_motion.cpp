#include "gui/session/camera_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luxdeck::gui {

namespace {

constexpr double kSteepestDeg = 89;
constexpr double kMargin = 1.06;       // of a fitted box
constexpr double kNearestM = 0.02;     // approaching stops here

Vec3d turned(const Vec3d& v, const Vec3d& axis, double degrees) {
    const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
    return v * c + axis.cross(v) * s + axis * (axis.dot(v) * (1 - c));
}

/// The tilt that keeps the direction from passing the vertical.
double allowedTilt(const CameraPose& pose, double tiltDeg) {
    const double now = std::asin(std::clamp(pose.direction.z, -1.0, 1.0)) / kDegree;
    return std::clamp(now + tiltDeg, std::min(now, -kSteepestDeg), std::max(now, kSteepestDeg)) - now;
}

double halfHeight(const CameraPose& pose) { return std::tan(pose.fovDeg * kDegree / 2); }

std::array<Vec3d, 8> corners(const Box3& box) {
    std::array<Vec3d, 8> out;
    for (unsigned i = 0; i < 8; ++i)
        out[i] = Vec3d((i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y, (i & 4U) != 0 ? box.max.z : box.min.z);
    return out;
}

CameraPose lookingAlong(const Vec3d& direction, const Vec3d& up) {
    CameraPose pose;
    pose.direction = direction.normalized();
    pose.up = (up - pose.direction * up.dot(pose.direction)).normalized();
    return pose;
}

CameraPose fittedParallel(CameraPose pose, double aspect, const Box3& box) {
    const Vec3d centre = (Vec3d(box.min) + Vec3d(box.max)) / 2;
    double across = 0.05, upwards = 0.05, along = 0;
    for (const auto& corner : corners(box)) {
        const Vec3d d = corner - centre;
        across = std::max(across, std::abs(d.dot(pose.right())));
        upwards = std::max(upwards, std::abs(d.dot(pose.up)));
        along = std::max(along, std::abs(d.dot(pose.direction)));
    }
    pose.heightM = 2 * kMargin * std::max(upwards, across / aspect);
    pose.position = centre - pose.direction * (along + 5);
    return pose;
}

}  // namespace

SightLine sightLine(const CameraPose& pose, double aspect, ScreenPoint at) {
    if (pose.parallel) {
        const double half = pose.heightM / 2;
        return {pose.position + pose.right() * (at.x * aspect * half) + pose.up * (at.y * half), pose.direction};
    }
    const double half = halfHeight(pose);
    return {pose.position, (pose.direction + pose.right() * (at.x * aspect * half) + pose.up * (at.y * half)).normalized()};
}

double depthOf(const CameraPose& pose, const Vec3d& point) { return (point - pose.position).dot(pose.direction); }

double metresPerUnit(const CameraPose& pose, double depthM) {
    return pose.parallel ? pose.heightM / 2 : std::max(depthM, 1e-6) * halfHeight(pose);
}

std::optional<ScreenPoint> seenAt(const CameraPose& pose, double aspect, const Vec3d& point) {
    const double depth = depthOf(pose, point);
    if (!pose.parallel && depth < 1e-6) return {};
    const double unit = metresPerUnit(pose, depth);
    const Vec3d d = point - pose.position;
    return ScreenPoint{d.dot(pose.right()) / (unit * aspect), d.dot(pose.up) / unit};
}

CameraPose orbited(const CameraPose& pose, const Vec3d& about, double turnDeg, double tiltDeg) {
    auto out = lookedAround(pose, turnDeg, tiltDeg);
    // Where the point is for the camera does not change.
    const Vec3d d = about - pose.position;
    const Vec3d seen(d.dot(pose.right()), d.dot(pose.up), d.dot(pose.direction));
    out.position = about - out.right() * seen.x - out.up * seen.y - out.direction * seen.z;
    return out;
}

CameraPose panned(const CameraPose& pose, double aspect, const Vec3d& point, ScreenPoint to) {
    const double depth = depthOf(pose, point), unit = metresPerUnit(pose, depth);
    const Vec3d d = point - pose.position;
    auto out = pose;
    out.position += pose.right() * (d.dot(pose.right()) - to.x * aspect * unit) + pose.up * (d.dot(pose.up) - to.y * unit);
    return out;
}

CameraPose approached(const CameraPose& pose, double aspect, const Vec3d& point, double factor) {
    auto out = pose;
    if (pose.parallel) {
        const auto at = seenAt(pose, aspect, point).value_or(ScreenPoint{});
        out.heightM = std::max(pose.heightM * factor, kNearestM);
        return panned(out, aspect, point, at);
    }
    const Vec3d d = pose.position - point;
    if (factor < 1 && d.length() * factor < kNearestM) return pose;
    out.position = point + d * factor;
    return out;
}

CameraPose lookedAround(const CameraPose& pose, double turnDeg, double tiltDeg) {
    const Vec3d axis = turned(pose.right(), {0, 0, 1}, turnDeg);
    const double tilt = allowedTilt(pose, tiltDeg);
    auto out = pose;
    out.direction = turned(turned(pose.direction, {0, 0, 1}, turnDeg), axis, tilt).normalized();
    const Vec3d up = turned(turned(pose.up, {0, 0, 1}, turnDeg), axis, tilt);
    out.up = (up - out.direction * up.dot(out.direction)).normalized();
    return out;
}

CameraPose walked(const CameraPose& pose, double forwardM, double rightM, double upM) {
    const Vec3d right = pose.right();
    // Looking straight down, ahead is where the top of the picture is.
    Vec3d ahead = std::abs(pose.direction.z) < 0.99 ? pose.direction : pose.up;
    ahead.z = 0;
    auto out = pose;
    out.position += ahead.normalized() * forwardM + Vec3d(right.x, right.y, 0).normalized() * rightM + Vec3d(0, 0, upM);
    return out;
}

CameraPose upright(const CameraPose& pose) {
    if (std::abs(pose.direction.z) > 0.9999) return pose;
    auto out = pose;
    out.up = (Vec3d(0, 0, 1) - pose.direction * pose.direction.z).normalized();
    return out;
}

CameraPose fitted(const CameraPose& pose, double aspect, const Box3& box) {
    if (box.isEmpty()) return pose;
    if (pose.parallel) return fittedParallel(pose, aspect, box);
    // The nearest place on each of the frustum's four planes' account: the largest shift back and the middle between sides.
    const double h = halfHeight(pose) / kMargin, w = h * aspect;
    const Vec3d centre = (Vec3d(box.min) + Vec3d(box.max)) / 2;
    double right = -1e300, left = -1e300, top = -1e300, bottom = -1e300;
    for (const auto& corner : corners(box)) {
        const Vec3d d = corner - centre;
        const double x = d.dot(pose.right()), y = d.dot(pose.up), z = d.dot(pose.direction);
        right = std::max(right, x - w * z), left = std::max(left, -x - w * z);
        top = std::max(top, y - h * z), bottom = std::max(bottom, -y - h * z);
    }
    const double back = std::max({(right + left) / (2 * w), (top + bottom) / (2 * h), 0.1});
    auto out = pose;
    out.position = centre + pose.right() * ((right - left) / 2) + pose.up * ((top - bottom) / 2) - pose.direction * back;
    return out;
}

CameraPose lookingFrom(Side side, double aspect, const Box3& box) {
    const auto from = [&](const Vec3d& direction, const Vec3d& up) {
        auto pose = lookingAlong(direction, up);
        pose.parallel = true;
        return fitted(pose, aspect, box);
    };
    switch (side) {
        case Side::Top: return from({0, 0, -1}, {0, 1, 0});
        case Side::Bottom: return from({0, 0, 1}, {0, 1, 0});
        case Side::Front: return from({0, 1, 0}, {0, 0, 1});
        case Side::Back: return from({0, -1, 0}, {0, 0, 1});
        case Side::Left: return from({1, 0, 0}, {0, 0, 1});
        case Side::Right: return from({-1, 0, 0}, {0, 0, 1});
        case Side::Iso: break;
    }
    auto pose = lookingAlong({0.42, 0.68, -0.60}, {0, 0, 1});
    pose.fovDeg = 32;  // long lenses keep rooms rectangular
    return fitted(pose, aspect, box);
}

CameraPose poseOf(const View& view, const Scene& scene) {
    auto pose = lookingAlong(view.direction, view.up);
    pose.position = Vec3d(scene.toRebased(view.position));
    // A fisheye's half sphere has no flat picture: what it looks at is shown wide.
    pose.fovDeg = view.kind == ViewKind::Fisheye ? 90 : view.verticalFovDeg;
    return pose;
}

View viewOf(const CameraPose& pose, const Scene& scene, const std::string& name, int width, int height) {
    View view;
    view.name = name;
    view.position = pose.position + scene.origin;
    view.direction = pose.direction;
    view.up = pose.up;
    view.verticalFovDeg = pose.fovDeg;
    view.width = std::max(width, 1);
    view.height = std::max(height, 1);
    return view;
}

}  // namespace luxdeck::gui
