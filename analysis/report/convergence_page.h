#pragma once

#include "analysis/report/page_layout.h"

namespace luxdeck::report {

/// Error against run time of this solve, on logarithmic axes, with the target and the slope of Monte Carlo.
void drawConvergence(Document& document);

}  // namespace luxdeck::report
