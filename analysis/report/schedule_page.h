#pragma once

#include "analysis/report/page_layout.h"

namespace luxdeck::report {

/// Luminaires with their totals, the plan they hang in, and the materials with their sources.
void drawSchedule(Document& document);

}  // namespace luxdeck::report
