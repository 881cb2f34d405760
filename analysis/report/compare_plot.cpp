#include "analysis/report/compare_plot.h"

#include "analysis/report/compare_drawing.h"
#include "analysis/report/drawing_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace luxdeck {

namespace {

using namespace report;

constexpr double kWidth = 200, kHeight = 132, kLeft = 10, kRight = 190;

void drawPlot(Canvas& canvas, const Comparison& c, const ComparedReference& reference) {
    canvas.fillRect({0, 0, kWidth, kHeight}, ink::kWhite);
    canvas.text(kLeft, 11, "Error against run time", {8, QFont::DemiBold, ink::kAccent});
    const TextStyle title{14, QFont::Bold};
    const auto name = line(c.project + (reference.picture ? ", view “" + reference.subject + "”" : ", calculation grids"));
    canvas.text(kLeft - 0.3, 18.2, canvas.elided(name, kRight - kLeft, title), title);
    canvas.text(kLeft, 23.2, referenceText(reference) + line(fmt::format("; {} repetitions of each run", c.repetitions)) + (c.complete ? "" : "; interrupted"), type::kBody.with(ink::kGrey));
    drawErrorCurves(canvas, {kLeft, 28, kRight - kLeft, kHeight - 28 - 5}, c, reference);
}

}  // namespace

Result<std::string> comparePlot(const Comparison& comparison, const std::string& subject, SheetFormat format) {
    const auto reference = std::ranges::find(comparison.reference, subject, &ComparedReference::subject);
    if (reference == comparison.reference.end()) return Error{ErrorCode::InvalidArgument, fmt::format("nothing was compared on \"{}\"", subject)};
    return drawingFile({line(comparison.project + ": error against run time"), kWidth, kHeight, [&](Canvas& canvas) { drawPlot(canvas, comparison, *reference); }}, format);
}

}  // namespace luxdeck
