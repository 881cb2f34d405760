#pragma once

#include <array>
#include <span>
#include <vector>

namespace luxdeck::tonemap {

/// A line of equal value, in grid coordinates: (0, 0) is the first sample, (columns - 1, rows - 1) the last.
struct Isoline {
    double level = 0;
    bool closed = false;                        ///< the last point joins the first (which is not repeated)
    std::vector<std::array<double, 2>> points;  ///< #P >= 2: column, row
};

/// The lines where a field of samples, linear along the cells' edges, has the given levels: marching squares. A
/// saddle is decided by the cell's mean. A sample that equals a level counts as above it. Cells with a NaN or
/// infinite corner have no lines. The higher values are on the right hand walking along, with rows downwards.
///
/// values   #S = columns * rows, row by row
/// levels   in any order; lines come level by level in that order
/// returns  polylines of at least 2 points, joined as far as they go; empty for a field under 2 x 2
/// cost     O(#S * #levels); pure, safe to call concurrently
std::vector<Isoline> isolines(std::span<const double> values, int columns, int rows, std::span<const double> levels);

/// Round levels from `low` to `high`: 1-2-5 steps of about `count` on a linear scale, 1-2-5 a decade (or only the
/// decades when they are many) on a logarithmic one. Empty unless low < high, and 0 < low when logarithmic.
std::vector<double> roundLevels(double low, double high, int count, bool logarithmic);

}  // namespace luxdeck::tonemap
