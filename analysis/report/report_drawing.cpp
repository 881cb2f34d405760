#include "analysis/report/report_drawing.h"

#include "analysis/compare/compare_output.h"
#include "analysis/report/compare_page.h"
#include "analysis/report/convergence_page.h"
#include "analysis/report/cover_page.h"
#include "analysis/report/method_page.h"
#include "analysis/report/plan_page.h"
#include "analysis/report/schedule_page.h"
#include "analysis/report/summary_page.h"
#include "analysis/report/views_page.h"

#include <fmt/format.h>

namespace luxdeck::report {

Pagination drawReport(Canvas& canvas, const std::function<void()>& newPage, const ReportContents& contents, const Pagination* known) {
    Document document(newPage, canvas, contents, known);
    drawCover(document);
    drawSummary(document);
    drawViews(document);
    for (std::size_t i = 0; contents.has(ReportSection::Grids) && i < contents.solve.grids.size(); ++i) drawGridPage(document, i);
    if (contents.has(ReportSection::Schedule)) drawSchedule(document);
    if (contents.has(ReportSection::Accuracy)) drawConvergence(document);
    drawComparison(document);
    if (contents.has(ReportSection::Method)) drawMethod(document);
    return document.pagination();
}

Result<void> checkReport(const ReportContents& contents) {
    for (const auto& view : contents.views) {
        const auto picture = QImage::fromData(reinterpret_cast<const uchar*>(view.png.data()), static_cast<int>(view.png.size()));
        if (picture.isNull())
            return Error{ErrorCode::InvalidArgument, fmt::format("{} bytes that are no picture, expected a PNG", view.png.size()),
                         fmt::format("view \"{}\"", view.name)};
    }
    if (contents.comparison)
        if (const auto comparison = readCompareJson(*contents.comparison, "comparison"); !comparison) return comparison.error();
    return {};
}

}  // namespace luxdeck::report
