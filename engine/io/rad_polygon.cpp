#include "engine/io/rad_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace luxdeck::rad {

namespace {

/// A point of the plane in which the polygon is looked at.
struct Flat {
    double x = 0, y = 0;
};

/// Corners by their index into the polygon.
using Ring = std::vector<std::size_t>;

/// Takes the rings of a polygon apart at its seams and joins them again.
class Seams {
public:
    explicit Seams(const std::vector<Vec3d>& corners) : corners_(corners) {
        Vec3d spread(0, 0, 0);  // not Newell's normal: rings of both directions may cancel in it
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            const Vec3d n = (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
            spread += Vec3d(std::abs(n.x), std::abs(n.y), std::abs(n.z));
        }
        const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
        for (const auto& c : corners) flat_.push_back({c[(axis + 1) % 3], c[(axis + 2) % 3]});
    }

    std::vector<Vec3d> rejoin() {
        Ring rest;
        for (std::size_t i = 0; i < corners_.size(); ++i) rest.push_back(i);
        while (cut(rest)) {}
        rings_.push_back(rest);
        const auto outer = std::max_element(rings_.begin(), rings_.end(), [&](const Ring& a, const Ring& b) { return std::abs(area(a)) < std::abs(area(b)); });
        const bool outermost = area(*outer) > 0;  // which ring is left at last does not say which is about the others
        for (auto& ring : rings_) {
            const bool hole = depth(ring) % 2 != 0;
            // Its first corner stays where it is: the seam ends there.
            if ((area(ring) > 0) != (outermost != hole)) std::reverse(ring.begin() + 1, ring.end());
        }
        emit(rings_.size() - 1);
        return std::move(out_);
    }

private:
    /// Takes the shortest ring that a seam closes out of `rest`; false: there is none.
    bool cut(Ring& rest) {
        const std::size_t n = rest.size();
        for (std::size_t length = 3; length + 4 < n; ++length)
            for (std::size_t i = 0; i < n; ++i) {
                const auto at = [&](std::size_t k) { return rest[(i + k) % n]; };
                // b ... b with a before and behind: a b is the seam
                if (corners_[at(0)] != corners_[at(length)] || corners_[at(n - 1)] != corners_[at(length + 1)]) continue;
                Ring ring, left;
                for (std::size_t k = 0; k < length; ++k) ring.push_back(at(k));
                for (std::size_t k = length + 1; k + 1 < n; ++k) left.push_back(at(k));
                attached_[left.front()].push_back(rings_.size());
                moveAttached(at(n - 1), left.front());
                moveAttached(at(length), ring.front());
                rings_.push_back(std::move(ring));
                rest = std::move(left);
                return true;
            }
        return false;
    }

    /// Rings that hang on a corner that is taken away hang on its twin.
    void moveAttached(std::size_t from, std::size_t to) {
        const auto found = attached_.find(from);
        if (found == attached_.end() || from == to) return;
        auto moved = std::move(found->second);
        attached_.erase(found);
        auto& target = attached_[to];
        target.insert(target.end(), moved.begin(), moved.end());
    }

    [[nodiscard]] double area(const Ring& ring) const {
        double sum = 0;
        const Flat& o = flat_[ring[0]];
        for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
            const Flat &a = flat_[ring[i]], &b = flat_[ring[i + 1]];
            sum += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
        }
        return sum;
    }

    [[nodiscard]] bool contains(const Ring& ring, const Flat& p) const {
        bool inside = false;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Flat &a = flat_[ring[i]], &b = flat_[ring[(i + 1) % ring.size()]];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
        }
        return inside;
    }

    /// How many of the other rings it lies in.
    [[nodiscard]] int depth(const Ring& ring) const {
        const Flat &a = flat_[ring[0]], &b = flat_[ring[1]];
        const Flat middle{(a.x + b.x) / 2, (a.y + b.y) / 2};  // corners may touch a ring about it, edges rarely do
        return static_cast<int>(std::count_if(rings_.begin(), rings_.end(), [&](const Ring& other) { return &other != &ring && contains(other, middle); }));
    }

    /// A ring and, at their corners, those that hang on it: there, around, and back over the seam.
    void emit(std::size_t index) {
        for (const auto corner : rings_[index]) {
            out_.push_back(corners_[corner]);
            const auto found = attached_.find(corner);
            if (found == attached_.end()) continue;
            for (const auto child : found->second) {
                emit(child);
                out_.push_back(corners_[rings_[child].front()]);
                out_.push_back(corners_[corner]);
            }
        }
    }

    const std::vector<Vec3d>& corners_;
    std::vector<Flat> flat_;
    std::vector<Ring> rings_;
    std::map<std::size_t, std::vector<std::size_t>> attached_;  ///< rings by the corner that their seam starts from
    std::vector<Vec3d> out_;
};

bool repeats(const std::vector<Vec3d>& corners) {
    auto sorted = corners;
    const auto less = [](const Vec3d& a, const Vec3d& b) { return std::pair(a.x, std::pair(a.y, a.z)) < std::pair(b.x, std::pair(b.y, b.z)); };
    std::sort(sorted.begin(), sorted.end(), less);
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

constexpr std::size_t kMostCorners = 4096;  // as many as are cut into triangles when concave

}  // namespace

std::vector<Vec3d> withHolesReversed(std::vector<Vec3d> corners) {
    if (corners.size() < 8 || corners.size() > kMostCorners || !repeats(corners)) return corners;
    return Seams(corners).rejoin();
}

}  // namespace luxdeck::rad
