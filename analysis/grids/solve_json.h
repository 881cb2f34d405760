#pragma once

#include "analysis/grids/solve_result.h"

#include <string>

namespace luxdeck {

/// `solve --json`, schema "luxdeck-solve/1"; an unknown (infinite) half-width is null.
std::string solveJson(const SolveResult& result);

}  // namespace luxdeck
