#pragma once

#include "analysis/grids/measurement.h"

#include <cstddef>
#include <span>
#include <vector>

namespace luxdeck {

/// Indices of targets, in groups of neighbours of at most `most` each: what an algorithm that shares light between
/// sensors is asked together. Sensors of one grid alone are grouped; what measures radiance or keeps layers stays alone.
std::vector<std::vector<std::size_t>> neighbours(std::span<const Target> targets, std::size_t most);

}  // namespace luxdeck
