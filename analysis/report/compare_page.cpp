#include "analysis/report/compare_page.h"

#include "analysis/compare/compare_output.h"
#include "analysis/report/compare_drawing.h"
#include "analysis/report/number_format.h"

#include <fmt/format.h>

#include <algorithm>

namespace luxdeck::report {

namespace {

constexpr double kPlotMm = 92;

QString timeText(const TimeTo& time) {
    if (time.how == Reached::NotReached) return "not reached";
    return line((time.how == Reached::AtOnce ? "≤ " : "") + formatSeconds(time.seconds));
}

/// Of an algorithm's largest run on a subject.
const ComparedRun* largestRun(const Comparison& c, const ComparedPlace& place) {
    const ComparedRun* last = nullptr;
    for (const auto& run : c.runs)
        if (run.subject == place.subject && run.algorithm == place.algorithm) last = &run;
    return last;
}

TableRow rowOf(const Comparison& c, const ComparedPlace& place) {
    const auto of = [&](const auto& x) { return x.subject == place.subject && x.algorithm == place.algorithm; };
    const auto* run = largestRun(c, place);
    const auto slope = std::ranges::find_if(c.slopes, of);
    TableRow row{{{QString::number(place.place)}, {line(place.algorithm), type::kStrong.with(colourOf(c, place.algorithm))}}};
    row.cells.push_back({run == nullptr || !run->rms ? QString("–") : line(formatInterval({100 * *run->rms, 100 * run->rmsCi95}) + " %")});
    row.cells.push_back({run == nullptr || !run->bias ? QString("none seen") : line(formatInterval({100 * *run->bias, 100 * run->biasCi95}) + " %")});
    row.cells.push_back({slope != c.slopes.end() ? slopeText(*slope) : QString("–")});
    for (const auto& time : c.timeTo)
        if (of(time) && time.error < 0.06) row.cells.push_back({timeText(time.time)});
    return row;
}

void drawSubject(Document& document, const Comparison& c, const ComparedReference& reference) {
    auto& canvas = document.canvas();
    document.startPage("Algorithms", line(reference.picture ? "Error against run time: view “" + reference.subject + "”" : std::string("Error against run time: calculation grids")));
    document.y += canvas.paragraph(sheet::kLeft, document.y - 3, sheet::kTextWidth, referenceText(reference) + line(fmt::format("; {} repetitions of each run{}.", c.repetitions, c.complete ? "" : "; interrupted")), type::kBody);
    drawErrorCurves(canvas, {sheet::kLeft, document.y + 2, sheet::kTextWidth, kPlotMm}, c, reference);
    document.y += kPlotMm + 8;
    std::vector<TableRow> rows;
    for (const auto& place : c.order)
        if (place.subject == reference.subject) rows.push_back(rowOf(c, place));
    if (rows.empty()) return;
    drawTable(document, {{"Place", 11}, {"Algorithm", 27}, {"Error, rms", 24, Align::Right}, {"Bias", 24, Align::Right}, {"Slope", 21, Align::Right}, {"to 5 %", 21, Align::Right},
                         {"to 2 %", 21, Align::Right}, {"to 1 %", 21, Align::Right}}, rows);
    document.y += canvas.paragraph(sheet::kLeft, document.y - 2, sheet::kTextWidth,
                                   "Error and bias of the largest run, relative to the value; bias is what repetition does not cure. Equal places cannot be told apart. Intervals are 95 %; the reference's own noise is taken out.",
                                   type::kSmall) + 3;
}

}  // namespace

void drawComparison(Document& document) {
    if (!document.contents().comparison) return;
    const auto read = readCompareJson(*document.contents().comparison, "comparison");
    if (!read) return;  // pdfBytes() has refused it already
    for (const auto& reference : read->reference) drawSubject(document, *read, reference);
    const double height = errorPlansHeightMm(*read, sheet::kTextWidth);
    if (height <= 0 || height > sheet::kBottom - sheet::kTop) return;
    document.startPage("Algorithms", "Where the errors are");
    drawErrorPlans(document.canvas(), {sheet::kLeft, document.y}, sheet::kTextWidth, *read);
    document.y += height;
}

}  // namespace luxdeck::report
