#pragma once

#include <vector>

namespace luxdeck {

/// The value at column x, row y of a surface, both in units of points from the first (whole numbers are the points);
/// bilinear between them, constant beyond the outer ones.
///
/// values  #rows x columns, row by row
double sampleField(const std::vector<double>& values, int columns, int rows, double x, double y);

}  // namespace luxdeck
