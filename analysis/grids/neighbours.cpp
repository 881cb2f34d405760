#include "analysis/grids/neighbours.h"

#include <algorithm>
#include <map>

namespace luxdeck {

namespace {

using Indices = std::vector<std::size_t>;

/// Halves a set of sensors across its longest side until the parts are small enough.
void split(std::span<const Target> targets, Indices indices, std::size_t most, std::vector<Indices>& groups) {
    if (indices.size() <= most) {
        groups.push_back(std::move(indices));
        return;
    }
    Box3 box;
    for (const auto i : indices) box.extendBy(targets[i].sensor.position);
    const auto axis = static_cast<int>(box.majorAxis());
    std::stable_sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
        return targets[a].sensor.position[axis] < targets[b].sensor.position[axis];
    });
    const auto middle = indices.begin() + static_cast<std::ptrdiff_t>(indices.size() / 2);
    split(targets, {indices.begin(), middle}, most, groups);
    split(targets, {middle, indices.end()}, most, groups);
}

}  // namespace

std::vector<std::vector<std::size_t>> neighbours(std::span<const Target> targets, std::size_t most) {
    std::vector<Indices> groups;
    std::map<std::uint32_t, Indices> grids;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const bool alone = most <= 1 || targets[i].radiance || targets[i].layers != nullptr;
        if (alone) groups.push_back({i});
        else grids[targets[i].grid].push_back(i);
    }
    for (auto& [grid, indices] : grids) split(targets, std::move(indices), most, groups);
    return groups;
}

}  // namespace luxdeck
