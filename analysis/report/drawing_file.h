#pragma once

#include "analysis/report/canvas.h"
#include "analysis/report/sheet_format.h"

#include <functional>
#include <string>

namespace luxdeck::report {

/// A drawing of one page.
struct Drawing {
    QString title;                          // in the file's header
    double widthMm = 297, heightMm = 210;
    std::function<void(Canvas&)> draw;
};

/// The file's bytes; the same drawing gives the same. Makes Qt ready.
///
/// errors  OutOfResources: no font is installed
Result<std::string> drawingFile(const Drawing& drawing, SheetFormat format);

}  // namespace luxdeck::report
