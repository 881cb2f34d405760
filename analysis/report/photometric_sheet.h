#pragma once

#include "analysis/photometry/photometry_summary.h"
#include "analysis/report/sheet_format.h"
#include "engine/core/result.h"

#include <string>

namespace luxdeck {

/// A luminaire's photometry on one A4 sheet: polar curve, C planes, and what was measured. The same file gives the
/// same bytes.
///
/// errors  OutOfResources: no font is installed
Result<std::string> photometricSheet(const CheckedFile& checked, SheetFormat format);

}  // namespace luxdeck
