#include "engine/scene/opening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace luxdeck {

namespace {

/// A projected area never falls below this part of the whole, so that a file whose candela do not vanish
/// at 90 degrees gives no infinite luminance.
constexpr float kGrazingFloor = 1e-3F;

constexpr float kInfinityM = std::numeric_limits<float>::infinity();

struct LocalPoint {
    Vec3 position, normal;
};

/// Areas of the box's faces across x, y and z, each of a pair.
std::array<float, 3> boxFaceAreas(const Vec3& h) {
    return {4 * h.y * h.z, 4 * h.x * h.z, 4 * h.x * h.y};
}

LocalPoint sampleBox(const Vec3& h, Vec2 u) {
    const auto areas = boxFaceAreas(h);
    const float total = areas[0] + areas[1] + areas[2];
    float pick = u.x * 2.0F;  // which half decides the sign, the rest the axis
    const float sign = pick < 1.0F ? -1.0F : 1.0F;
    pick = (pick < 1.0F ? pick : pick - 1.0F) * total;
    int axis = 0;
    while (axis < 2 && pick >= areas[static_cast<std::size_t>(axis)]) pick -= areas[static_cast<std::size_t>(axis++)];
    const float along = std::min(pick / std::max(areas[static_cast<std::size_t>(axis)], 1e-30F), 1.0F);
    LocalPoint point{{0, 0, 0}, {0, 0, 0}};  // Imath's vectors start uninitialised
    point.normal[axis] = sign;
    point.position[axis] = sign * h[axis];
    point.position[(axis + 1) % 3] = (2 * along - 1) * h[(axis + 1) % 3];
    point.position[(axis + 2) % 3] = (2 * u.y - 1) * h[(axis + 2) % 3];
    return point;
}

Vec2 uniformDisc(Vec2 u) {
    const float radius = std::sqrt(u.x), angle = 2 * kPi * u.y;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

LocalPoint sampleCylinder(const Vec3& h, Vec2 u) {
    const float side = 4 * kPi * h.x * h.z, cap = kPi * h.x * h.x;
    float pick = u.x * (side + 2 * cap);
    if (pick < side) {
        const float angle = 2 * kPi * u.y;
        const Vec3 normal{std::cos(angle), std::sin(angle), 0};
        return {{h.x * normal.x, h.x * normal.y, (2 * pick / side - 1) * h.z}, normal};
    }
    pick -= side;
    const float sign = pick < cap ? -1.0F : 1.0F;
    const Vec2 d = uniformDisc({std::min((pick < cap ? pick : pick - cap) / cap, 1.0F), u.y});
    return {{h.x * d.x, h.x * d.y, sign * h.z}, {0, 0, sign}};
}

LocalPoint sampleSphere(float radius, Vec2 u) {
    const float z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0F, 1 - z * z)), angle = 2 * kPi * u.y;
    const Vec3 n{r * std::cos(angle), r * std::sin(angle), z};
    return {n * radius, n};
}

using Meeting = PlacedOpening::Meeting;

std::optional<Meeting> meetFlat(const PlacedOpening& o, const Vec3& p, const Vec3& d, float tMin, float tMax) {
    if (d.z == 0.0F) return std::nullopt;
    const float t = -p.z / d.z;
    if (!(t > tMin && t < tMax)) return std::nullopt;
    const float x = p.x + t * d.x, y = p.y + t * d.y;
    const bool inside = o.shape == OpeningShape::Disc
                            ? x * x + y * y <= o.halfM.x * o.halfM.x
                            : std::abs(x) <= o.halfM.x && std::abs(y) <= o.halfM.y;
    if (!inside) return std::nullopt;
    return Meeting{t, {0, 0, -1}};
}

std::optional<Meeting> meetBox(const Vec3& h, const Vec3& p, const Vec3& d, float tMin, float tMax) {
    float enter = -kInfinityM, leave = kInfinityM;
    int enterAxis = 0, leaveAxis = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (d[axis] == 0.0F) {
            if (std::abs(p[axis]) > h[axis]) return std::nullopt;
            continue;
        }
        const float a = (-std::copysign(h[axis], d[axis]) - p[axis]) / d[axis];
        const float b = (std::copysign(h[axis], d[axis]) - p[axis]) / d[axis];
        if (a > enter) enter = a, enterAxis = axis;
        if (b < leave) leave = b, leaveAxis = axis;
    }
    if (enter > leave) return std::nullopt;
    const bool outside = enter > tMin;
    const float t = outside ? enter : leave;
    if (!(t > tMin && t < tMax)) return std::nullopt;
    const int axis = outside ? enterAxis : leaveAxis;
    Vec3 normal(0, 0, 0);
    normal[axis] = outside ? -std::copysign(1.0F, d[axis]) : std::copysign(1.0F, d[axis]);
    return Meeting{t, normal};
}

std::optional<Meeting> meetSphere(float radius, const Vec3& p, const Vec3& d, float tMin, float tMax) {
    // In double: b^2 - c cancels for a small sphere far away.
    const Vec3d pd(p), dd(d);
    const double b = pd.dot(dd), c = pd.dot(pd) - double{radius} * radius, root2 = b * b - c;
    if (root2 < 0) return std::nullopt;
    const double root = std::sqrt(root2);
    for (const double t : {-b - root, -b + root})
        if (t > tMin && t < tMax) return Meeting{static_cast<float>(t), Vec3((pd + dd * t) / double{radius})};
    return std::nullopt;
}

std::optional<Meeting> meetCylinder(const Vec3& h, const Vec3& p, const Vec3& d, float tMin, float tMax) {
    std::optional<Meeting> best;
    const auto offer = [&](double t, const Vec3& normal) {
        if (t > tMin && t < tMax && (!best || t < best->distance)) best = Meeting{static_cast<float>(t), normal};
    };
    const double a = double{d.x} * d.x + double{d.y} * d.y, b = double{p.x} * d.x + double{p.y} * d.y;
    const double c = double{p.x} * p.x + double{p.y} * p.y - double{h.x} * h.x, root2 = b * b - a * c;
    if (a > 0 && root2 >= 0)
        for (const double t : {(-b - std::sqrt(root2)) / a, (-b + std::sqrt(root2)) / a})
            if (std::abs(p.z + t * d.z) <= h.z)
                offer(t, {static_cast<float>((p.x + t * d.x) / h.x), static_cast<float>((p.y + t * d.y) / h.x), 0});
    if (d.z != 0.0F)
        for (const float sign : {-1.0F, 1.0F}) {
            const double t = (sign * h.z - p.z) / double{d.z}, x = p.x + t * d.x, y = p.y + t * d.y;
            if (x * x + y * y <= double{h.x} * h.x) offer(t, {0, 0, sign});
        }
    return best;
}

}  // namespace

PlacedOpening PlacedOpening::of(const Luminaire& luminaire, const LuminousOpening& opening) {
    PlacedOpening placed{opening.shape, luminaire.position, luminaire.frame,
                         Vec3(Vec3d(opening.lengthM, opening.widthM, opening.heightM) * 0.5)};
    if (placed.flat()) placed.centre -= luminaire.frame.normal * kFlushM;
    return placed;
}

float PlacedOpening::areaM2() const {
    const Vec3& h = halfM;
    switch (shape) {
        case OpeningShape::Point: return 0;
        case OpeningShape::Rectangle: return 4 * h.x * h.y;
        case OpeningShape::Disc: return kPi * h.x * h.x;
        case OpeningShape::Box: {
            const auto areas = boxFaceAreas(h);
            return 2 * (areas[0] + areas[1] + areas[2]);
        }
        case OpeningShape::Cylinder: return 4 * kPi * h.x * h.z + 2 * kPi * h.x * h.x;
        case OpeningShape::Sphere: return 4 * kPi * h.x * h.x;
    }
    return 0;
}

float PlacedOpening::projectedAreaM2(const Vec3& d) const {
    const Vec3& h = halfM;
    switch (shape) {
        case OpeningShape::Point: return 0;
        case OpeningShape::Rectangle: return 4 * h.x * h.y * std::max(std::abs(d.z), kGrazingFloor);
        case OpeningShape::Disc: return kPi * h.x * h.x * std::max(std::abs(d.z), kGrazingFloor);
        case OpeningShape::Box: {
            const auto areas = boxFaceAreas(h);
            return std::abs(d.x) * areas[0] + std::abs(d.y) * areas[1] + std::abs(d.z) * areas[2];
        }
        case OpeningShape::Cylinder:
            return 4 * h.x * h.z * std::sqrt(std::max(0.0F, 1 - d.z * d.z)) + kPi * h.x * h.x * std::abs(d.z);
        case OpeningShape::Sphere: return kPi * h.x * h.x;
    }
    return 0;
}

PlacedOpening::SurfacePoint PlacedOpening::samplePoint(Vec2 u) const {
    LocalPoint local{{0, 0, 0}, {0, 0, -1}};
    switch (shape) {
        case OpeningShape::Point: break;
        case OpeningShape::Rectangle: local.position = {(2 * u.x - 1) * halfM.x, (2 * u.y - 1) * halfM.y, 0}; break;
        case OpeningShape::Disc: {
            const Vec2 d = uniformDisc(u);
            local.position = {d.x * halfM.x, d.y * halfM.x, 0};
            break;
        }
        case OpeningShape::Box: local = sampleBox(halfM, u); break;
        case OpeningShape::Cylinder: local = sampleCylinder(halfM, u); break;
        case OpeningShape::Sphere: local = sampleSphere(halfM.x, u); break;
    }
    return {centre + frame.toWorld(local.position), frame.toWorld(local.normal), flat()};
}

std::optional<PlacedOpening::Meeting> PlacedOpening::intersect(const Vec3& origin, const Vec3& direction, float tMin,
                                                               float tMax) const {
    const Vec3 p = frame.toLocal(origin - centre), d = frame.toLocal(direction);
    std::optional<Meeting> met;
    switch (shape) {
        case OpeningShape::Point: return std::nullopt;
        case OpeningShape::Rectangle:
        case OpeningShape::Disc: met = meetFlat(*this, p, d, tMin, tMax); break;
        case OpeningShape::Box: met = meetBox(halfM, p, d, tMin, tMax); break;
        case OpeningShape::Cylinder: met = meetCylinder(halfM, p, d, tMin, tMax); break;
        case OpeningShape::Sphere: met = meetSphere(halfM.x, p, d, tMin, tMax); break;
    }
    if (met) met->normal = frame.toWorld(met->normal);
    return met;
}

Box3 PlacedOpening::bounds() const {
    const float z = flat() ? kFlushM : halfM.z;
    const Vec3 half{halfM.x, halfM.y, shape == OpeningShape::Sphere ? halfM.x : z};
    Box3 box;
    for (int corner = 0; corner < 8; ++corner)
        box.extendBy(centre + frame.toWorld({(corner & 1) != 0 ? half.x : -half.x, (corner & 2) != 0 ? half.y : -half.y,
                                             (corner & 4) != 0 ? half.z : -half.z}));
    return box;
}

}  // namespace luxdeck
