#pragma once

#include "analysis/report/report_contents.h"

#include <string>
#include <string_view>

namespace luxdeck {

/// The report's JSON twin, schema "luxdeck-report/1": everything the PDF prints, pictures as base64 PNG.
/// An infinite half-width is null.
///
/// errors  none in practice: text that is not UTF-8 is repaired
Result<std::string> toJson(const ReportContents& contents);

/// The contents a twin was made of: writePdf() of them gives the same bytes.
///
/// errors  Parse: "grids[2].mean: what was seen, what was expected"
Result<ReportContents> fromJson(std::string_view json);

}  // namespace luxdeck
