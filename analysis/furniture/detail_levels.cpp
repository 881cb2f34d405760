#include "analysis/furniture/detail_levels.h"

#include <cmath>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace luxdeck {

namespace {

/// Cubes along the longest side of the object at the coarsest level.
constexpr float kCoarsest = 6;

struct Cluster {
    Vec3d sum{0, 0, 0};
    std::size_t count = 0;
    std::uint32_t nearest = 0;
    double distance2 = 1e300;
};

std::uint64_t keyOf(const Vec3& p, const Vec3& n, const Vec3& low, float side) {
    std::uint64_t key = 0;
    int main = 0;
    for (int axis = 0; axis < 3; ++axis) {
        key = key << 20 | static_cast<std::uint64_t>(std::floor((p[axis] - low[axis]) / side));
        if (std::abs(n[axis]) > std::abs(n[main])) main = axis;
    }
    return key * 6 + static_cast<std::uint64_t>(2 * main + (n[main] < 0 ? 1 : 0));
}

DetailLevel cluster(const MovableObject& object, const Vec3& low, float side) {
    DetailLevel out;
    out.standsFor.resize(object.positions.size());
    std::unordered_map<std::uint64_t, std::uint32_t> index;
    std::vector<Cluster> clusters;
    for (std::size_t v = 0; v < object.positions.size(); ++v) {
        const auto [found, isNew] = index.try_emplace(keyOf(object.positions[v], object.normals[v], low, side), static_cast<std::uint32_t>(clusters.size()));
        if (isNew) clusters.emplace_back();
        auto& c = clusters[found->second];
        c.sum += Vec3d(object.positions[v]), ++c.count;
        out.standsFor[v] = found->second;
    }
    for (std::size_t v = 0; v < object.positions.size(); ++v) {
        auto& c = clusters[out.standsFor[v]];
        const double d = (Vec3d(object.positions[v]) - c.sum / static_cast<double>(c.count)).length2();
        if (d < c.distance2) c.distance2 = d, c.nearest = static_cast<std::uint32_t>(v);
    }
    for (const auto& c : clusters) out.shown.push_back(c.nearest);
    return out;
}

}  // namespace

void makeDetailLevels(MovableObject& object, int count) {
    DetailLevel all;
    all.shown.resize(object.positions.size());
    std::iota(all.shown.begin(), all.shown.end(), 0U);
    all.standsFor = all.shown;
    object.levels = {std::move(all)};
    Box3 box;
    for (const auto& p : object.positions) box.extendBy(p);
    const Vec3 size = box.max - box.min;
    const float longest = std::max({size.x, size.y, size.z, 1e-3F});
    for (int i = 0; i < count; ++i) {
        auto level = cluster(object, box.min, longest / (kCoarsest * static_cast<float>(1 << (count - 1 - i))));
        // One that leaves nearly everything in is not worth its place.
        if (4 * level.shown.size() < 3 * object.levels.back().shown.size()) object.levels.push_back(std::move(level));
    }
}

}  // namespace luxdeck
