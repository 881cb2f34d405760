#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace luxdeck {

/// The cells and vertices of a volume: a regular first level, any cell of which may hold a grid of split^3 cells, and
/// those again. A vertex that cells share is there once. Source: Greger 1996, 4.1 and 4.3.
class Lattice {
public:
    static constexpr std::uint32_t kNoChild = 0xffffffffU;
    /// Cells along an axis at the finest level that coordinates can count.
    static constexpr int kMostAcross = 1 << 20;

    struct Cell {
        std::array<std::uint32_t, 8> vertices{};  // x fastest, then y, then z
        std::uint32_t firstChild = kNoChild;      // split^3 cells from there on, x fastest
    };
    /// Where a point lies: a cell without children, and how far along each of its sides, 0 .. 1.
    struct Place {
        std::uint32_t cell = 0;
        Vec3 fraction{0, 0, 0};
    };

    Lattice() = default;
    /// bounds  of the first level [m]; cells  of it along each axis; split  of a divided cell along each axis, 2 or more;
    /// depth  how often cells may be divided
    ///
    /// errors  InvalidArgument: bounds empty or not finite, a number out of range, more than kMostAcross cells along an axis
    static Result<Lattice> create(const Box3& bounds, std::array<int, 3> cells, int split, int depth);

    [[nodiscard]] const Box3& bounds() const { return bounds_; }
    [[nodiscard]] std::array<int, 3> firstLevel() const { return counts_; }
    [[nodiscard]] int split() const { return split_; }
    [[nodiscard]] int depth() const { return depth_; }
    [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
    [[nodiscard]] const std::vector<Vec3>& vertices() const { return vertices_; }

    /// Points outside the bounds belong to the cell at the boundary nearest to them.
    [[nodiscard]] Place locate(const Vec3& position) const;
    /// Corners of a cell [m].
    [[nodiscard]] Box3 box(std::uint32_t cell) const { return {vertices_[cells_[cell].vertices[0]], vertices_[cells_[cell].vertices[7]]}; }
    [[nodiscard]] bool divided(std::uint32_t cell) const { return cells_[cell].firstChild != kNoChild; }
    /// How often the first level was divided to make it.
    [[nodiscard]] int levelOf(std::uint32_t cell) const { return levels_[cell]; }

    /// Divides a cell that is not; its new vertices come after all others.
    void divide(std::uint32_t cell);
    /// Divides cells without children, level by level, as long as `wanted` says so and the depth allows.
    void divideWhere(const std::function<bool(const Box3&)>& wanted);

    /// As it was written by whoever has cells() alone.
    ///
    /// firstChildren  of all cells, in their order
    /// errors         Parse: not what a lattice of this shape has
    static Result<Lattice> restore(const Box3& bounds, std::array<int, 3> cells, int split, int depth,
                                   const std::vector<std::uint32_t>& firstChildren);

private:
    using Coordinates = std::array<std::uint32_t, 3>;  // in cells of the finest level

    std::uint32_t vertexAt(const Coordinates& at);
    void addCell(const Coordinates& corner, std::uint32_t side, int level);

    Box3 bounds_;
    std::array<int, 3> counts_{1, 1, 1};
    int split_ = 2, depth_ = 0;
    Vec3 cellsPerM_{1, 1, 1};                        // of the first level
    std::uint32_t finest_ = 1;                       // finest cells across one of the first level
    std::vector<Cell> cells_;                        // the first level first
    std::vector<Coordinates> corners_;               // of cells
    std::vector<std::uint8_t> levels_;               // of cells
    std::vector<Vec3> vertices_;
    std::unordered_map<std::uint64_t, std::uint32_t> vertexIndex_;
};

}  // namespace luxdeck
