#include "engine/volume/lattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

std::uint64_t keyOf(const std::array<std::uint32_t, 3>& c) {
    return std::uint64_t{c[0]} | std::uint64_t{c[1]} << 21 | std::uint64_t{c[2]} << 42;
}

}  // namespace

Result<Lattice> Lattice::create(const Box3& bounds, std::array<int, 3> cells, int split, int depth) {
    if (bounds.isEmpty() || !isFinite(bounds.min) || !isFinite(bounds.max))
        return Error{ErrorCode::InvalidArgument, "the volume's bounds are empty or not finite"};
    if (split < 2 || split > 31 || depth < 0 || depth > 10)
        return Error{ErrorCode::InvalidArgument, fmt::format("cells divided {} times into {}^3, expected 0 .. 10 times into 2 .. 31", depth, split)};
    Lattice out;
    out.bounds_ = bounds, out.counts_ = cells, out.split_ = split, out.depth_ = depth;
    double finest = 1;
    for (int i = 0; i < depth; ++i) finest *= split;
    for (int axis = 0; axis < 3; ++axis) {
        if (cells[axis] < 1 || cells[axis] * finest > kMostAcross)
            return Error{ErrorCode::InvalidArgument, fmt::format("{} cells along an axis, divided {} times by {}: expected 1 .. {} of the smallest",
                                                                 cells[axis], depth, split, kMostAcross)};
        if (!(bounds.max[axis] > bounds.min[axis]))
            return Error{ErrorCode::InvalidArgument, fmt::format("the volume's bounds have no extent along {}", "xyz"[axis])};
    }
    const double vertices = (cells[0] + 1.0) * (cells[1] + 1.0) * (cells[2] + 1.0);
    if (vertices > 5e7) return Error{ErrorCode::OutOfResources, fmt::format("{:.0f} vertices in the first level, expected 50 million at most", vertices)};
    out.finest_ = static_cast<std::uint32_t>(finest);
    std::array<std::uint32_t, 3> n{};
    for (int axis = 0; axis < 3; ++axis) {
        n[axis] = static_cast<std::uint32_t>(cells[axis]);
        out.cellsPerM_[axis] = static_cast<float>(cells[axis] / (double{bounds.max[axis]} - bounds.min[axis]));
    }
    // Vertices row by row, so that those of a cell lie close together in memory.
    for (std::uint32_t z = 0; z <= n[2]; ++z)
        for (std::uint32_t y = 0; y <= n[1]; ++y)
            for (std::uint32_t x = 0; x <= n[0]; ++x) out.vertexAt({x * out.finest_, y * out.finest_, z * out.finest_});
    for (std::uint32_t z = 0; z < n[2]; ++z)
        for (std::uint32_t y = 0; y < n[1]; ++y)
            for (std::uint32_t x = 0; x < n[0]; ++x) out.addCell({x * out.finest_, y * out.finest_, z * out.finest_}, out.finest_, 0);
    return out;
}

std::uint32_t Lattice::vertexAt(const Coordinates& at) {
    const auto [found, isNew] = vertexIndex_.try_emplace(keyOf(at), static_cast<std::uint32_t>(vertices_.size()));
    if (isNew) {
        Vec3 p{0, 0, 0};
        for (int axis = 0; axis < 3; ++axis) {
            const double part = at[axis] / (static_cast<double>(counts_[axis]) * finest_);
            p[axis] = static_cast<float>(bounds_.min[axis] + part * (double{bounds_.max[axis]} - bounds_.min[axis]));
        }
        vertices_.push_back(p);
    }
    return found->second;
}

void Lattice::addCell(const Coordinates& corner, std::uint32_t side, int level) {
    Cell cell;
    for (std::uint32_t i = 0; i < 8; ++i)
        cell.vertices[i] = vertexAt({corner[0] + side * (i & 1U), corner[1] + side * (i >> 1U & 1U), corner[2] + side * (i >> 2U)});
    cells_.push_back(cell);
    corners_.push_back(corner);
    levels_.push_back(static_cast<std::uint8_t>(level));
}

void Lattice::divide(std::uint32_t cell) {
    const auto corner = corners_[cell];
    const int level = levels_[cell] + 1;
    std::uint32_t side = finest_;
    for (int i = 0; i < level; ++i) side /= static_cast<std::uint32_t>(split_);
    cells_[cell].firstChild = static_cast<std::uint32_t>(cells_.size());
    const auto n = static_cast<std::uint32_t>(split_);
    for (std::uint32_t z = 0; z < n; ++z)
        for (std::uint32_t y = 0; y < n; ++y)
            for (std::uint32_t x = 0; x < n; ++x) addCell({corner[0] + x * side, corner[1] + y * side, corner[2] + z * side}, side, level);
}

void Lattice::divideWhere(const std::function<bool(const Box3&)>& wanted) {
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell)  // grows while it is walked: children are asked in turn
        if (!divided(cell) && levels_[cell] < depth_ && wanted(box(cell))) divide(cell);
}

Lattice::Place Lattice::locate(const Vec3& position) const {
    std::array<int, 3> index{};
    Vec3 fraction{0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
        const float q = (position[axis] - bounds_.min[axis]) * cellsPerM_[axis];
        const float inside = std::clamp(q, 0.0F, static_cast<float>(counts_[axis]));
        index[axis] = std::min(static_cast<int>(inside), counts_[axis] - 1);
        fraction[axis] = inside - static_cast<float>(index[axis]);
    }
    auto cell = static_cast<std::uint32_t>((index[2] * counts_[1] + index[1]) * counts_[0] + index[0]);
    while (divided(cell)) {
        for (int axis = 0; axis < 3; ++axis) {
            const float q = fraction[axis] * static_cast<float>(split_);
            index[axis] = std::min(static_cast<int>(q), split_ - 1);
            fraction[axis] = q - static_cast<float>(index[axis]);
        }
        cell = cells_[cell].firstChild + static_cast<std::uint32_t>((index[2] * split_ + index[1]) * split_ + index[0]);
    }
    return {cell, fraction};
}

Result<Lattice> Lattice::restore(const Box3& bounds, std::array<int, 3> cells, int split, int depth,
                                 const std::vector<std::uint32_t>& firstChildren) {
    auto lattice = create(bounds, cells, split, depth);
    if (!lattice) return lattice;
    // Divided in the order of their first children, the cells come out as they were.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < firstChildren.size(); ++i)
        if (firstChildren[i] != kNoChild) order.emplace_back(firstChildren[i], i);
    std::sort(order.begin(), order.end());
    for (const auto& [child, cell] : order) {
        if (child != lattice->cells_.size() || cell >= child || lattice->levels_[cell] >= depth)
            return Error{ErrorCode::Parse, fmt::format("the cells of the lattice do not fit together: cell {} has its first child at {}", cell, child)};
        lattice->divide(cell);
    }
    if (lattice->cells_.size() != firstChildren.size())
        return Error{ErrorCode::Parse, fmt::format("{} cells in the lattice, its divisions give {}", firstChildren.size(), lattice->cells_.size())};
    return lattice;
}

}  // namespace luxdeck
