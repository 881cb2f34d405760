#pragma once

#include "analysis/grids/solve_result.h"

#include <QIcon>

namespace luxdeck::gui {

/// The report's symbol of a verdict: tick, cross, question mark; empty for Verdict::None.
QIcon verdictIcon(Verdict verdict);

/// Not met before undecided before met: what a grid's row shows.
Verdict worstVerdict(const GridResult& grid);

}  // namespace luxdeck::gui
