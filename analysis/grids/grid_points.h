#pragma once

#include "engine/core/result.h"
#include "engine/io/project.h"

#include <vector>

namespace luxdeck {

/// The largest spacing that EN 12464-1 allows for a surface whose longer side is d: 0.2 * 5^log10(d), at
/// most 10 m. d > 0 [m].
double gridSpacingM(double d);

/// Where a calculation grid asks for light.
struct GridLayout {
    int columns = 0;                 // along u; 0 for free points
    int rows = 0;                    // along v
    Vec3d origin, u, v;              // of the surface without its border [m]
    std::vector<Vec3d> points;       // #N, rows from v = 0; user coordinates [m]
    std::vector<Vec3d> normals;      // #N, unit
};

/// Divides a grid's surface: the border is taken off, each side is divided so that no cell is longer than
/// the spacing, points sit in the cells' centres. When one side is twice the other or more, the shorter one
/// decides, so that cells stay near square (EN 12464-1, 4.4).
///
/// errors  InvalidArgument when the border leaves nothing, or more than a million points would result
Result<GridLayout> layOut(const CalculationGrid& grid);

}  // namespace luxdeck
