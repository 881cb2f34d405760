#pragma once

#include "engine/core/vec.h"

#include <vector>

namespace luxdeck::rad {

/// The corners of a polygon so that its holes run the other way round than what is about them.
///
/// Radiance cuts holes with seams (an edge there and back) and asks only how often a line crosses the outline, so
/// files have holes of either direction. Rings that seams join are found by their repeated corners; those that lie
/// within an odd number of others are turned against the outermost, the rest with it.
///
/// corners  #C x 3, C >= 3; comes back as it is when nothing repeats
/// cost     O(C^2) for each ring
std::vector<Vec3d> withHolesReversed(std::vector<Vec3d> corners);

}  // namespace luxdeck::rad
