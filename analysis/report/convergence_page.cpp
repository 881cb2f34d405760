#include "analysis/report/convergence_page.h"

#include "analysis/report/number_format.h"

#include <algorithm>
#include <cmath>

namespace luxdeck::report {

namespace {

/// Logarithmic axes over a rectangle of the page.
struct LogPlot {
    QRectF area;
    double x0, x1, y0, y1;  // log10 of the ends

    [[nodiscard]] QPointF at(double x, double y) const {
        return {area.left() + area.width() * (std::log10(x) - x0) / (x1 - x0),
                area.bottom() - area.height() * (std::log10(y) - y0) / (y1 - y0)};
    }
};

/// Passes that can stand on logarithmic axes.
std::vector<ErrorAtTime> plottable(const SolveResult& solve) {
    std::vector<ErrorAtTime> out;
    for (const auto& entry : solve.trace)
        if (entry.seconds > 0 && entry.relativeError > 0 && std::isfinite(entry.relativeError)) out.push_back(entry);
    return out;
}

/// Ends of a logarithmic axis at 1, 2 or 5 times a power of ten outside the data.
void roundLog(double& low, double& high) {
    const auto down = [](double v) {
        const double decade = std::pow(10.0, std::floor(std::log10(v) + 1e-9)), m = v / decade;
        return decade * (m >= 5 ? 5 : m >= 2 ? 2 : 1);
    };
    const auto up = [](double v) {
        const double decade = std::pow(10.0, std::floor(std::log10(v) - 1e-9)), m = v / decade;
        return decade * (m <= 1 ? 1 : m <= 2 ? 2 : m <= 5 ? 5 : 10);
    };
    low = down(low), high = up(high);
    if (high < low * 4) low /= 2, high *= 2;
}

LogPlot plotOf(const std::vector<ErrorAtTime>& trace, double target, const QRectF& area) {
    double t0 = 1e300, t1 = 0, e0 = 1e300, e1 = 0;
    for (const auto& entry : trace) {
        t0 = std::min(t0, entry.seconds), t1 = std::max(t1, entry.seconds);
        for (const double e : {entry.relativeError, entry.rmsPointError})
            if (e > 0 && std::isfinite(e)) e0 = std::min(e0, e), e1 = std::max(e1, e);
    }
    if (target > 0) e0 = std::min(e0, target * 0.9), e1 = std::max(e1, target);
    roundLog(t0, t1);
    roundLog(e0, e1);
    return {area, std::log10(t0), std::log10(t1), std::log10(e0), std::log10(e1)};
}

/// 1, 2 and 5 times powers of ten between the ends; powers alone over more than three decades.
std::vector<double> logTicks(double low, double high) {
    std::vector<double> ticks;
    for (double decade = std::floor(low); decade <= high + 1e-9; ++decade)
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor > 1 && high - low > 3) continue;
            const double position = decade + std::log10(factor);
            if (position >= low - 1e-9 && position <= high + 1e-9) ticks.push_back(std::pow(10.0, position));
        }
    return ticks;
}

void drawAxes(Canvas& canvas, const LogPlot& plot) {
    const TextStyle label{7, QFont::Normal, ink::kGrey};
    for (const double t : logTicks(plot.x0, plot.x1)) {
        const auto p = plot.at(t, std::pow(10, plot.y0));
        canvas.stroke(p.x(), plot.area.top(), p.x(), p.y(), ink::kLight, 0.15);
        canvas.text(p.x(), p.y() + 4, line(formatNumber(t, 2)), label.aligned(Align::Centre));
    }
    for (const double e : logTicks(plot.y0, plot.y1)) {
        const auto p = plot.at(std::pow(10, plot.x0), e);
        canvas.stroke(p.x(), p.y(), plot.area.right(), p.y(), ink::kLight, 0.15);
        canvas.text(p.x() - 1.6, p.y() + 0.9, line(formatNumber(e * 100, 2)), label.aligned(Align::Right));
    }
    canvas.stroke(plot.area.left(), plot.area.bottom(), plot.area.right(), plot.area.bottom(), ink::kBlack, 0.3);
    canvas.stroke(plot.area.left(), plot.area.top(), plot.area.left(), plot.area.bottom(), ink::kBlack, 0.3);
    canvas.text(plot.area.right(), plot.area.bottom() + 8.5, "Run time in s", type::kLabel.aligned(Align::Right));
    canvas.text(sheet::kLeft, plot.area.top() - 4, "95 % half-width over value, in %", type::kLabel);
}

void drawSeries(Canvas& canvas, const LogPlot& plot, const std::vector<ErrorAtTime>& trace,
                double ErrorAtTime::* value, QColor colour) {
    QPolygonF path;
    for (const auto& entry : trace)
        if (entry.*value > 0 && std::isfinite(entry.*value)) path << plot.at(entry.seconds, entry.*value);
    canvas.polyline(path, colour, 0.5);
    for (const auto& p : path) canvas.disc(p.x(), p.y(), 0.75, colour);
}

/// The slope -1/2 that independent samples give, through the last pass.
void drawGuide(Canvas& canvas, const LogPlot& plot, const ErrorAtTime& last) {
    const double t0 = std::pow(10, plot.x0), t1 = std::pow(10, plot.x1);
    const auto error = [&](double t) { return last.relativeError * std::sqrt(last.seconds / t); };
    canvas.clip(plot.area);
    canvas.polyline(QPolygonF(QVector<QPointF>{plot.at(t0, error(t0)), plot.at(t1, error(t1))}), ink::kGrey, 0.25, Qt::DashLine);
    canvas.unclip();
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
    drawAxes(canvas, plot);
    if (solve.targetError > 0) {
        const auto p = plot.at(trace.back().seconds, solve.targetError);
        canvas.stroke(area.left(), p.y(), area.right(), p.y(), ink::kUndecided, 0.5);
    }
    drawGuide(canvas, plot, trace.back());
    drawSeries(canvas, plot, trace, &ErrorAtTime::rmsPointError, ink::kBlack);
    drawSeries(canvas, plot, trace, &ErrorAtTime::relativeError, ink::kAccent);
    document.y = area.bottom() + 17;
    drawKey(document, solve.targetError);
    drawTraceTable(document);
}

}  // namespace luxdeck::report
