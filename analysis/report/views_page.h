#pragma once

#include "analysis/report/page_layout.h"

namespace luxdeck::report {

/// Every picture with the name of its operator; a false-colour one with its scale.
void drawViews(Document& document);

}  // namespace luxdeck::report
