#pragma once

#include "analysis/report/page_layout.h"

#include <functional>

namespace luxdeck::report {

/// What the report is laid out in, whatever it is drawn on: sizes of type are whole dots, so that pages break alike.
inline constexpr int kDotsPerInch = 1200;

/// Draws the report, page after page.
///
/// canvas   of kDotsPerInch, on the first page
/// newPage  makes what the canvas draws on the next page
/// known    what a first pass returned; null: this is it, and references to later pages are left blank
Pagination drawReport(Canvas& canvas, const std::function<void()>& newPage, const ReportContents& contents, const Pagination* known);

/// errors  InvalidArgument: a view that is no picture; Parse: the comparison
Result<void> checkReport(const ReportContents& contents);

}  // namespace luxdeck::report
