#include "engine/volume/group_lookup.h"

#include "engine/core/rng.h"
#include "engine/volume/corners.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

std::uint32_t mainAxis(const Vec3& n) {
    const float x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    const int axis = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    return static_cast<std::uint32_t>(2 * axis + (n[axis] < 0 ? 1 : 0));
}

}  // namespace

void GroupLookup::growTable() {
    const std::size_t size = table_.empty() ? 1024 : 2 * table_.size();
    const auto old = std::move(table_);
    table_.assign(size, Slot{});
    for (const auto& slot : old) {
        if (slot.round != round_) continue;
        std::size_t at = mix64(slot.key) & (size - 1);
        while (table_[at].round == round_) at = (at + 1) & (size - 1);
        table_[at] = slot;
    }
}

std::uint32_t GroupLookup::groupOf(std::uint64_t key, std::uint32_t cell, std::uint32_t point) {
    if (2 * (groups_.size() + 1) > table_.size()) growTable();
    std::size_t at = mix64(key) & (table_.size() - 1);
    for (; table_[at].round == round_; at = (at + 1) & (table_.size() - 1))
        if (table_[at].key == key) return table_[at].group;
    const auto group = static_cast<std::uint32_t>(groups_.size());
    table_[at] = {key, round_, group};
    groups_.push_back({cell, point});
    return group;
}

void GroupLookup::find(std::span<const Vec3> positions, std::span<const Vec3> normals) {
    if (++round_ == 0) table_.clear(), round_ = 1;
    points_.resize(positions.size());
    groups_.clear(), traced_.clear();
    const auto& lattice = volume_->lattice;
    std::uint64_t lastKey = ~std::uint64_t{0};
    std::uint32_t lastGroup = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vec3 from = liftedOff(positions[i], normals[i]);
        const auto place = lattice.locate(from);
        const bool traced = room_ != nullptr && cornersMayBeHidden(*volume_, place, from);
        std::uint64_t key = std::uint64_t{place.cell} << 10;
        if (traced) {
            for (int axis = 0; axis < 3; ++axis)
                key |= std::uint64_t{std::min(static_cast<std::uint32_t>(place.fraction[axis] * kAcross), kAcross - 1)} << (4 + 2 * axis);
            key |= std::uint64_t{mainAxis(normals[i])} << 1 | 1;
        }
        if (key != lastKey) lastGroup = groupOf(key, place.cell, static_cast<std::uint32_t>(i)), lastKey = key;
        if (traced_.size() < groups_.size()) traced_.push_back(traced ? 1 : 0);
        points_[i] = {lastGroup, place.fraction};
    }
    traceCorners(positions, normals);
}

void GroupLookup::traceCorners(std::span<const Vec3> positions, std::span<const Vec3> normals) {
    rays_.clear(), rayOf_.clear();
    const auto& lattice = volume_->lattice;
    for (std::uint32_t g = 0; g < groups_.size(); ++g) {
        auto& group = groups_[g];
        const auto& corners = lattice.cells()[group.cell].vertices;
        const Vec3 from = liftedOff(positions[group.first], normals[group.first]);
        for (std::uint32_t c = 0; c < 8; ++c) {
            if (!volume_->quality[corners[c]].usable()) continue;
            group.seen |= static_cast<std::uint8_t>(1U << c);
            if (traced_[g] != 0) rays_.push_back(rayBetween(from, lattice.vertices()[corners[c]])), rayOf_.push_back(8 * g + c);
        }
    }
    hidden_.resize(rays_.size());
    if (room_ != nullptr) room_->occluded(rays_, hidden_, Targets::Opaque);
    rayCount_ = rays_.size();
    for (std::size_t i = 0; i < hidden_.size(); ++i)
        if (hidden_[i] != 0) groups_[rayOf_[i] / 8].seen &= static_cast<std::uint8_t>(~(1U << rayOf_[i] % 8));
    for (auto& group : groups_)
        if (group.seen == 0 && room_ != nullptr) lookAround(group, liftedOff(positions[group.first], normals[group.first]));
}

/// The nearest vertices of the cells around that see the point, weighed by the inverse square of their distance.
void GroupLookup::lookAround(Group& group, const Vec3& from) {
    const auto& lattice = volume_->lattice;
    std::array<std::uint32_t, 216> near{};
    const std::size_t count = usableAround(*volume_, group.cell, near);
    const auto distance2 = [&](std::uint32_t v) { return std::max((lattice.vertices()[v] - from).length2(), 1e-12F); };
    std::sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), [&](std::uint32_t a, std::uint32_t b) {
        return distance2(a) != distance2(b) ? distance2(a) < distance2(b) : a < b;
    });
    std::size_t kept = 0;
    float sum = 0;
    for (std::size_t i = 0; i < count && kept < 8; ++i) {
        const Ray ray = rayBetween(from, lattice.vertices()[near[i]]);
        std::uint8_t hidden = 0;
        room_->occluded({&ray, 1}, {&hidden, 1}, Targets::Opaque);
        ++rayCount_;
        if (hidden != 0) continue;
        group.vertices[kept] = near[i], group.weights[kept] = 1 / distance2(near[i]);
        sum += group.weights[kept++];
    }
    for (auto& w : group.weights) w = kept > 0 ? w / sum : 0;
    group.around = kept > 0;
}

GroupLookup::Corners GroupLookup::weights(std::size_t point) const {
    const auto& [index, f] = points_[point];
    const auto& group = groups_[index];
    if (group.around) return {group.vertices.data(), group.weights, true};
    Corners out;
    out.vertices = volume_->lattice.cells()[group.cell].vertices.data();
    if (group.seen == 0) return out;
    out.weights = trilinearWeights(f);
    float sum = 0;
    for (std::uint32_t c = 0; c < 8; ++c) {
        out.weights[c] = (group.seen >> c & 1U) != 0 ? std::max(out.weights[c], kLeastWeight) : 0;
        sum += out.weights[c];
    }
    const float scale = 1 / sum;
    for (auto& w : out.weights) w *= scale;
    out.known = true;
    return out;
}

}  // namespace luxdeck
