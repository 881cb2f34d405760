#pragma once

#include "analysis/compare/comparison.h"
#include "analysis/report/sheet_format.h"

#include <filesystem>
#include <string>

namespace luxdeck {

/// Error against run time of all algorithms on one subject, on logarithmic axes. The same comparison gives the same bytes.
///
/// errors  OutOfResources: no font is installed
Result<std::string> comparePlot(const Comparison& comparison, const std::string& subject, SheetFormat format);

/// Where the errors of the grids' points are: a plan for each algorithm. Only of comparisons that have grids.
///
/// errors  OutOfResources: no font is installed
Result<std::string> errorPlans(const Comparison& comparison, SheetFormat format);

/// All of them as .svg, .png and .pdf into a folder that is there.
///
/// errors  those above, and of writeFileAtomically()
Result<void> writeComparePlots(const Comparison& comparison, const std::filesystem::path& folder);

}  // namespace luxdeck
