#pragma once

#include "analysis/report/page_layout.h"

namespace luxdeck::report {

/// The first page: the project's name, the room's picture, who and when.
void drawCover(Document& document);

/// The view whose picture stands for the room: the first that is not in false colours; null when there is none.
const ReportView* coverView(const ReportContents& contents);

}  // namespace luxdeck::report
