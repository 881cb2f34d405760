#include "engine/io/pattern_frame.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

Vec3d turned(const Vec3d& v, const Matrix4d& m) {
    return {v.x * m[0][0] + v.y * m[1][0] + v.z * m[2][0], v.x * m[0][1] + v.y * m[1][1] + v.z * m[2][1],
            v.x * m[0][2] + v.y * m[1][2] + v.z * m[2][2]};
}

double determinant(const Matrix4d& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

}  // namespace

Result<PatternFrame> PatternFrame::create(const Matrix4d& toWorld, const std::string& where) {
    const double volume = determinant(toWorld);
    bool finite = true;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) finite = finite && std::isfinite(toWorld[i][j]);
    if (!finite || !std::isnormal(volume))
        return Error{ErrorCode::InvalidArgument, "a transform that flattens space, expected one that can be undone",
                     where};
    PatternFrame frame;
    frame.toWorld_ = toWorld;
    frame.toLocal_ = toWorld.inverse();
    frame.shrink_ = 1 / std::cbrt(std::abs(volume));
    return frame;
}

cal::Inputs PatternFrame::inputs(const PatternPoint& at, const Rgb& materialColour) const {
    const Vec3d direction = turned(Vec3d(at.direction), toLocal_) / shrink_;
    const Vec3d normal = turned(Vec3d(at.normal), toLocal_) / shrink_;
    const auto& m = toLocal_;
    const Vec3d position = turned(at.position, toLocal_) + Vec3d(m[3][0], m[3][1], m[3][2]);
    const double rdot = -Vec3d(at.direction).dot(Vec3d(at.normal));
    const double distance = at.distance * shrink_;
    return {direction.x, direction.y, direction.z,      normal.x,         normal.y,        normal.z,
            position.x,  position.y,  position.z,       distance,         distance,        std::clamp(rdot, -1.0, 1.0),
            at.uv.x,     at.uv.y,     materialColour.r, materialColour.g, materialColour.b};
}

Vec3d PatternFrame::toWorld(const Vec3d& local) const { return turned(local, toWorld_) * shrink_; }

std::map<std::string, double, std::less<>> PatternFrame::constants() const {
    std::map<std::string, double, std::less<>> result{{"S", shrink_}};
    for (int axis = 0; axis < 3; ++axis) {
        const std::string name(1, "xyz"[axis]);
        result["T" + name] = toLocal_[3][axis];
        result["I" + name] = toLocal_[0][axis] / shrink_;
        result["J" + name] = toLocal_[1][axis] / shrink_;
        result["K" + name] = toLocal_[2][axis] / shrink_;
    }
    return result;
}

}  // namespace luxdeck
