#include "engine/io/obj_polygon.h"

#include <cmath>
#include <cstddef>
#include <numeric>

namespace luxdeck::obj {

namespace {

struct Point {
    double x = 0, y = 0;
};

double cross(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon as seen against its mean normal (Newell's method), counter-clockwise.
std::vector<Point> project(std::span<const Vec3d> corners) {
    Vec3d normal(0, 0, 0);
    const Vec3d origin = corners[0];
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += (corners[i] - origin).cross(corners[(i + 1) % corners.size()] - origin);
    int axis = 0;  // the one to drop: where the normal is largest
    for (int i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double sign = normal[axis] < 0 ? -1 : 1;
    std::vector<Point> points(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        points[i] = {(corners[i][u] - origin[u]) * sign, corners[i][v] - origin[v]};
    return points;
}

/// Convex and going round once: every turn is to the left, and x changes its direction twice at most.
bool isConvex(const std::vector<Point>& p) {
    const std::size_t n = p.size();
    int changes = 0;
    double lastStep = 0, firstStep = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Point& b = p[(i + 1) % n];
        if (cross(p[i], b, p[(i + 2) % n]) < 0) return false;
        const double step = b.x - p[i].x;
        if (step == 0) continue;
        if (lastStep != 0 && (step > 0) != (lastStep > 0)) ++changes;
        if (firstStep == 0) firstStep = step;
        lastStep = step;
    }
    if ((lastStep > 0) != (firstStep > 0)) ++changes;
    return changes <= 2;
}

bool contains(const Point& a, const Point& b, const Point& c, const Point& p) {
    return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
}

bool same(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }

/// Ear clipping on a ring of corners. Source: Meisters 1975.
class EarClipper {
public:
    explicit EarClipper(const std::vector<Point>& points) : points_(points), next_(points.size()), previous_(points.size()) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            next_[i] = static_cast<std::uint32_t>((i + 1) % points.size());
            previous_[next_[i]] = static_cast<std::uint32_t>(i);
        }
    }

    void clip(std::vector<std::array<std::uint32_t, 3>>& triangles) {
        std::uint32_t at = 0;
        std::size_t left = points_.size(), tried = 0;
        while (left > 3) {
            // A ring that crosses itself may have no ear: then any corner is cut off, so that the end is reached.
            if (isEar(at) || tried >= left) {
                triangles.push_back({previous_[at], at, next_[at]});
                next_[previous_[at]] = next_[at];
                previous_[next_[at]] = previous_[at];
                --left;
                tried = 0;
                at = next_[next_[at]];  // skipping one gives rounder triangles than a fan about one corner
            } else {
                at = next_[at];
                ++tried;
            }
        }
        triangles.push_back({previous_[at], at, next_[at]});
    }

private:
    [[nodiscard]] bool isEar(std::uint32_t at) const {
        const std::uint32_t before = previous_[at], after = next_[at];
        const Point &a = points_[before], &b = points_[at], &c = points_[after];
        if (cross(a, b, c) <= 0) return false;
        for (std::uint32_t i = next_[after]; i != before; i = next_[i]) {
            const Point& p = points_[i];
            // Only inward corners can stand in an ear; bridges to holes repeat corners, which are not in the way.
            if (cross(points_[previous_[i]], p, points_[next_[i]]) > 0) continue;
            if (!same(p, a) && !same(p, b) && !same(p, c) && contains(a, b, c, p)) return false;
        }
        return true;
    }

    const std::vector<Point>& points_;
    std::vector<std::uint32_t> next_, previous_;
};

void fan(std::size_t corners, std::vector<std::array<std::uint32_t, 3>>& triangles) {
    for (std::uint32_t i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
}

}  // namespace

bool triangulate(std::span<const Vec3d> corners, std::vector<std::array<std::uint32_t, 3>>& triangles) {
    triangles.clear();
    if (corners.size() == 3) {
        triangles.push_back({0, 1, 2});
        return true;
    }
    const auto points = project(corners);
    if (isConvex(points)) {
        fan(corners.size(), triangles);
        return true;
    }
    if (corners.size() > kMaxConcaveCorners) return false;
    EarClipper(points).clip(triangles);
    return true;
}

}  // namespace luxdeck::obj
