#include "analysis/report/compare_plot.h"

#include "analysis/compare/compare_folder.h"
#include "analysis/report/compare_drawing.h"
#include "analysis/report/drawing_file.h"
#include "engine/core/file.h"

#include <fmt/format.h>

#include <algorithm>

namespace luxdeck {

namespace {

using namespace report;

constexpr double kWidth = 200, kHeight = 132, kLeft = 10, kRight = 190;

void drawHead(Canvas& canvas, const QString& kind, const Comparison& c, const QString& title, const QString& about) {
    const TextStyle style{14, QFont::Bold};
    canvas.text(kLeft, 11, kind, {8, QFont::DemiBold, ink::kAccent});
    canvas.text(kLeft - 0.3, 18.2, canvas.elided(title, kRight - kLeft, style), style);
    canvas.text(kLeft, 23.2, about + (c.complete ? "" : "; interrupted"), type::kBody.with(ink::kGrey));
}

void drawPlot(Canvas& canvas, const Comparison& c, const ComparedReference& reference) {
    canvas.fillRect({0, 0, kWidth, kHeight}, ink::kWhite);
    const auto title = line(c.project + (reference.picture ? ", view “" + reference.subject + "”" : ", calculation grids"));
    drawHead(canvas, "Error against run time", c, title, referenceText(reference) + line(fmt::format("; {} repetitions of each run", c.repetitions)));
    drawErrorCurves(canvas, {kLeft, 28, kRight - kLeft, kHeight - 28 - 5}, c, reference);
}

void drawPlans(Canvas& canvas, const Comparison& c, double height) {
    canvas.fillRect({0, 0, kWidth, height}, ink::kWhite);
    drawHead(canvas, "Where the errors are", c, line(c.project + ", calculation grids"), "Errors of the points at each algorithm's largest budget, mean of its repetitions");
    drawErrorPlans(canvas, {kLeft, 28}, kRight - kLeft, c);
}

}  // namespace

Result<std::string> comparePlot(const Comparison& comparison, const std::string& subject, SheetFormat format) {
    const auto reference = std::ranges::find(comparison.reference, subject, &ComparedReference::subject);
    if (reference == comparison.reference.end()) return Error{ErrorCode::InvalidArgument, fmt::format("nothing was compared on \"{}\"", subject)};
    return drawingFile({line(comparison.project + ": error against run time"), kWidth, kHeight, [&](Canvas& canvas) { drawPlot(canvas, comparison, *reference); }}, format);
}

Result<std::string> errorPlans(const Comparison& comparison, SheetFormat format) {
    const double height = 28 + errorPlansHeightMm(comparison, kRight - kLeft) + 3;
    return drawingFile({line(comparison.project + ": where the errors are"), kWidth, height, [&](Canvas& canvas) { drawPlans(canvas, comparison, height); }}, format);
}

Result<void> writeComparePlots(const Comparison& comparison, const std::filesystem::path& folder) {
    const auto write = [&](const std::string& name, SheetFormat format, const Result<std::string>& drawing) {
        return drawing ? writeFileAtomically(folder / (name + extensionOf(format)), *drawing) : drawing.error();
    };
    for (const auto format : {SheetFormat::Svg, SheetFormat::Png, SheetFormat::Pdf}) {
        for (const auto& reference : comparison.reference)
            if (auto ok = write("error-against-time-" + fileNameOf(reference.subject), format, comparePlot(comparison, reference.subject, format)); !ok) return ok;
        if (!comparison.grids.empty())
            if (auto ok = write("errors-grids", format, errorPlans(comparison, format)); !ok) return ok;
    }
    return {};
}

}  // namespace luxdeck
