#pragma once

#include "analysis/compare/comparison.h"
#include "analysis/report/sheet_format.h"

#include <string>

namespace luxdeck {

/// Error against run time of all algorithms on one subject, on logarithmic axes. The same comparison gives the same bytes.
///
/// errors  OutOfResources: no font is installed
Result<std::string> comparePlot(const Comparison& comparison, const std::string& subject, SheetFormat format);

}  // namespace luxdeck
