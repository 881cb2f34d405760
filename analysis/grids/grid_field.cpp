#include "analysis/grids/grid_field.h"

#include <algorithm>
#include <cstddef>

namespace luxdeck {

double sampleField(const std::vector<double>& values, int columns, int rows, double x, double y) {
    x = std::clamp(x, 0.0, columns - 1.0);
    y = std::clamp(y, 0.0, rows - 1.0);
    const int x0 = std::min(static_cast<int>(x), std::max(columns - 2, 0)), x1 = std::min(x0 + 1, columns - 1);
    const int y0 = std::min(static_cast<int>(y), std::max(rows - 2, 0)), y1 = std::min(y0 + 1, rows - 1);
    const double fx = x - x0, fy = y - y0;
    const auto at = [&](int i, int j) { return values[static_cast<std::size_t>(j) * columns + i]; };
    return (at(x0, y0) * (1 - fx) + at(x1, y0) * fx) * (1 - fy) + (at(x0, y1) * (1 - fx) + at(x1, y1) * fx) * fy;
}

}  // namespace luxdeck
