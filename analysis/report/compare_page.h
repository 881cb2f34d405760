#pragma once

#include "analysis/report/page_layout.h"

namespace luxdeck::report {

/// Algorithms against each other: for each subject the plot and a table, then where the errors of the grids are. Nothing when
/// the contents hold no comparison.
void drawComparison(Document& document);

}  // namespace luxdeck::report
