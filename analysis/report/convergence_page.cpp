#include "analysis/report/convergence_page.h"

#include "analysis/report/log_plot.h"
#include "analysis/report/number_format.h"

#include <algorithm>
#include <cmath>

namespace luxdeck::report {

namespace {

/// Passes that can stand on logarithmic axes.
std::vector<ErrorAtTime> plottable(const SolveResult& solve) {
    std::vector<ErrorAtTime> out;
    for (const auto& entry : solve.trace)
        if (entry.seconds > 0 && entry.relativeError > 0 && std::isfinite(entry.relativeError)) out.push_back(entry);
    return out;
}

LogPlot plotOf(const std::vector<ErrorAtTime>& trace, double target, const QRectF& area) {
    double t0 = 1e300, t1 = 0, e0 = 1e300, e1 = 0;
    for (const auto& entry : trace) {
        t0 = std::min(t0, entry.seconds), t1 = std::max(t1, entry.seconds);
        for (const double e : {entry.relativeError, entry.rmsPointError})
            if (e > 0 && std::isfinite(e)) e0 = std::min(e0, e), e1 = std::max(e1, e);
    }
    if (target > 0) e0 = std::min(e0, target * 0.9), e1 = std::max(e1, target);
    return logPlotOf(area, t0, t1, e0, e1);
}

void drawSeries(Canvas& canvas, const LogPlot& plot, const std::vector<ErrorAtTime>& trace,
                double ErrorAtTime::* value, QColor colour) {
    QPolygonF path;
    for (const auto& entry : trace)
        if (entry.*value > 0 && std::isfinite(entry.*value)) path << plot.at(entry.seconds, entry.*value);
    canvas.polyline(path, colour, 0.5);
    for (const auto& p : path) canvas.disc(p.x(), p.y(), 0.75, colour);
}

void drawKey(Document& document, double target) {
    auto& canvas = document.canvas();
    const double y = document.y;
    const auto entry = [&](int column, QColor colour, Qt::PenStyle pen, const QString& text) {
        const double x = sheet::column(column);
        canvas.stroke(x, y - 1, x + 7, y - 1, colour, 0.5, pen);
        canvas.paragraph(x + 9, y - 3.2, sheet::kColumn - 9, text, type::kSmall.with(ink::kBlack));
    };
    entry(0, ink::kAccent, Qt::SolidLine, "largest of the statistics");
    entry(1, ink::kBlack, Qt::SolidLine, "root mean square of the points");
    entry(2, ink::kGrey, Qt::DashLine, "slope −1/2 (error halves in four times the time)");
    if (target > 0) entry(3, ink::kUndecided, Qt::SolidLine, line("target " + formatPercent(target)));
    document.y += 12;
}

void drawTraceTable(Document& document) {
    const auto& trace = document.contents().solve.trace;
    std::vector<TableRow> rows;
    // At most sixteen passes, evenly spaced, the last one always among them.
    const std::size_t every = (trace.size() + 15) / 16;
    for (std::size_t i = 0; i < trace.size(); ++i) {
        if ((trace.size() - 1 - i) % every != 0) continue;
        const auto& entry = trace[i];
        rows.push_back({{{line(formatSeconds(entry.seconds))},
                         {line(formatCount(entry.samples))},
                         {line(formatPercent(entry.relativeError)), type::kStrong},
                         {line(formatPercent(entry.rmsPointError))}}});
    }
    if (rows.empty()) return;
    drawTable(document,
              {{"Run time", 32}, {"Paths", 46, Align::Right}, {"Largest of the statistics ±", 46, Align::Right},
               {"Root mean square of the points ±", 46, Align::Right}}, rows);
}

}  // namespace

void drawConvergence(Document& document) {
    const auto& solve = document.contents().solve;
    document.startPage("Accuracy", "Error against run time");
    auto& canvas = document.canvas();
    const auto trace = plottable(solve);
    if (trace.empty()) {
        document.y += canvas.paragraph(sheet::kLeft, document.y, sheet::kTextWidth,
                                       "No pass of this run has a finite error above zero: there is nothing to plot.", type::kBody) + 5;
        drawTraceTable(document);
        return;
    }
    const QRectF area(sheet::kLeft + 11, document.y + 7, sheet::kTextWidth - 11, 100);
    const auto plot = plotOf(trace, solve.targetError, area);
    drawLogAxes(canvas, plot, "Run time in s", "95 % half-width over value, in %");
    if (solve.targetError > 0) {
        const auto p = plot.at(trace.back().seconds, solve.targetError);
        canvas.stroke(area.left(), p.y(), area.right(), p.y(), ink::kUndecided, 0.5);
    }
    drawHalfSlope(canvas, plot, trace.back().seconds, trace.back().relativeError);
    drawSeries(canvas, plot, trace, &ErrorAtTime::rmsPointError, ink::kBlack);
    drawSeries(canvas, plot, trace, &ErrorAtTime::relativeError, ink::kAccent);
    document.y = area.bottom() + 17;
    drawKey(document, solve.targetError);
    drawTraceTable(document);
}

}  // namespace luxdeck::report
