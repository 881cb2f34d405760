#pragma once

#include "analysis/report/page_layout.h"

namespace luxdeck::report {

/// One calculation surface: its plan with values, isolines and colours, its statistics and its place in the
/// room. Free points become a table.
void drawGridPage(Document& document, std::size_t index);

}  // namespace luxdeck::report
