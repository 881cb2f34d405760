#pragma once

#include "analysis/grids/solve_result.h"
#include "cli/command.h"
#include "cli/load.h"

#include <string>

namespace luxdeck::cli {

/// Solves with the options of the command line; `defaultError` when neither error nor time was asked for.
Result<SolveResult> runSolve(const Loaded& loaded, const Effort& effort, const Context& context, double defaultError,
                             bool byLuminaire = false);

/// The result as people read it in a terminal.
std::string solveText(const SolveResult& result);

/// Interrupted, not met, not reached or ok, in this order.
Exit exitOf(const SolveResult& result);

}  // namespace luxdeck::cli
