#include "analysis/report/compare_drawing.h"

#include "analysis/report/log_plot.h"
#include "analysis/report/number_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace luxdeck::report {

namespace {

constexpr double kLabelsMm = 46;      // right of the plot
constexpr double kLabelRowMm = 8.6;   // a name and what stands beneath
constexpr double kMarkerMm = 1.15;
constexpr double kSigma95 = 1.96;

/// Source: Okabe & Ito 2008, their yellow (too pale on white) left out, with a dark grey and a brown behind.
const std::array<QColor, 9> kColours{QColor(0, 114, 178), QColor(213, 94, 0),  QColor(0, 158, 115), QColor(204, 121, 167), QColor(20, 22, 26),
                                     QColor(86, 180, 233), QColor(230, 159, 0), QColor(118, 70, 38), QColor(130, 134, 140)};

/// One algorithm's runs on the subject, by increasing time, bounds included.
struct Curve {
    std::string algorithm;
    std::size_t index = 0;
    std::vector<const ComparedRun*> runs;

    [[nodiscard]] double lastError() const { return runs.back()->rms.value_or(runs.back()->rmsAtMost); }
};

std::vector<Curve> curvesOf(const Comparison& c, const std::string& subject) {
    std::vector<Curve> curves;
    for (std::size_t a = 0; a < c.algorithms.size(); ++a) {
        Curve curve{c.algorithms[a].name, a, {}};
        for (const auto& run : c.runs)
            if (run.subject == subject && run.algorithm == curve.algorithm && run.seconds > 0 && run.rmsAtMost > 0) curve.runs.push_back(&run);
        std::ranges::stable_sort(curve.runs, {}, &ComparedRun::seconds);
        if (!curve.runs.empty()) curves.push_back(std::move(curve));
    }
    return curves;
}

LogPlot frameOf(const QRectF& area, const std::vector<Curve>& curves, double floor) {
    double t0 = 1e300, t1 = 0, e0 = floor > 0 ? floor : 1e300, e1 = 0;
    for (const auto& curve : curves)
        for (const auto* run : curve.runs) {
            const double e = run->rms.value_or(run->rmsAtMost);
            t0 = std::min(t0, run->seconds), t1 = std::max(t1, run->seconds);
            e0 = std::min(e0, e), e1 = std::max(e1, e);
        }
    return logPlotOf(area, 0.9 * t0, 1.1 * t1, 0.8 * e0, 1.15 * e1);
}

/// Within the area, where the axes are.
QRectF innerOf(const QRectF& area) { return {area.left() + 11, area.top() + 6, area.width() - 11 - kLabelsMm, area.height() - 6 - 10}; }

/// Shapes beside colours, so that a print in grey tells curves apart too.
void drawMarker(Canvas& canvas, const QPointF& p, std::size_t index, QColor colour) {
    const double r = kMarkerMm;
    const auto polygon = [&](std::initializer_list<QPointF> corners) {
        QPolygonF out;
        for (const auto& corner : corners) out << p + corner * r;
        canvas.fill(out, colour);
    };
    switch (index % 4) {
        case 0: canvas.disc(p.x(), p.y(), r, colour); return;
        case 1: polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}}); return;
        case 2: polygon({{0, -1.25}, {1.15, 0.85}, {-1.15, 0.85}}); return;
        default: polygon({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}}); return;
    }
}

/// A bound: the error is somewhere below it.
void drawArrow(Canvas& canvas, const QPointF& p, QColor colour) {
    canvas.stroke(p.x() - kMarkerMm, p.y(), p.x() + kMarkerMm, p.y(), colour, 0.35);
    canvas.stroke(p.x(), p.y(), p.x(), p.y() + 3, colour, 0.35);
    canvas.fill(QPolygonF(QVector<QPointF>{p + QPointF(-0.8, 2.4), p + QPointF(0.8, 2.4), p + QPointF(0, 3.9)}), colour);
}

void drawCurve(Canvas& canvas, const LogPlot& plot, const Curve& curve, QColor colour) {
    QPolygonF path;
    for (const auto* run : curve.runs)
        if (run->rms) path << plot.at(run->seconds, *run->rms);
    canvas.clip(plot.area.adjusted(-2, -2, 2, 2));
    canvas.polyline(path, colour, 0.55);
    for (const auto* run : curve.runs) {
        if (!run->rms) {
            drawArrow(canvas, plot.at(run->seconds, run->rmsAtMost), colour);
            continue;
        }
        const auto p = plot.at(run->seconds, *run->rms), high = plot.at(run->seconds, *run->rms + run->rmsCi95);
        const auto low = plot.at(run->seconds, std::max(*run->rms - run->rmsCi95, 0.5 * plot.bottom()));
        canvas.stroke(p.x(), high.y(), p.x(), low.y(), colour, 0.25);
        drawMarker(canvas, p, curve.index, colour);
    }
    canvas.unclip();
}

QString detailOf(const Comparison& c, const std::string& subject, const Curve& curve) {
    std::string text;
    const auto slope = std::ranges::find_if(c.slopes, [&](const auto& s) { return s.subject == subject && s.algorithm == curve.algorithm; });
    if (slope != c.slopes.end() && std::isfinite(slope->ci95)) text = "slope " + slopeText(*slope).toStdString();
    const auto& last = *curve.runs.back();
    if (last.bias) text += fmt::format("{}bias {:.2g} %", text.empty() ? "" : ", ", 100 * *last.bias);
    return line(text);
}

/// Where the labels stand: at the ends of their curves, pushed apart, all within the plot's height.
std::vector<double> labelHeights(const LogPlot& plot, const std::vector<Curve>& curves) {
    std::vector<double> y;
    for (const auto& curve : curves) y.push_back(plot.at(1, curve.lastError()).y());
    const double top = plot.area.top() + 2, row = std::min(kLabelRowMm, (plot.area.height() - 2) / static_cast<double>(curves.size()));
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = std::max(y[i], i == 0 ? top : y[i - 1] + row);
    double bottom = plot.area.bottom() - 4;
    for (std::size_t i = y.size(); i-- > 0; bottom = y[i] - row) y[i] = std::min(y[i], bottom);
    return y;
}

void drawLabels(Canvas& canvas, const LogPlot& plot, const Comparison& c, const std::string& subject, std::vector<Curve> curves, const PlotInks& inks) {
    std::ranges::stable_sort(curves, std::greater<>{}, &Curve::lastError);
    const auto heights = labelHeights(plot, curves);
    const double x = plot.area.right() + 7;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const auto& curve = curves[i];
        const auto colour = colourOf(c, curve.algorithm, inks);
        const auto end = plot.at(curve.runs.back()->seconds, curve.lastError());
        auto faint = colour;
        faint.setAlpha(110);
        canvas.polyline(QPolygonF(QVector<QPointF>{end + QPointF(kMarkerMm + 0.6, 0), QPointF(x - 5, heights[i]), QPointF(x - 2.8, heights[i])}), faint, 0.18);
        drawMarker(canvas, {x - 1, heights[i]}, curve.index, colour);
        const auto name = type::kStrong.with(colour);
        canvas.text(x + 1.4, heights[i] + Canvas::capHeight(name) / 2, canvas.elided(line(curve.algorithm), kLabelsMm - 9, name), name);
        canvas.text(x + 1.4, heights[i] + Canvas::capHeight(name) / 2 + 3.1, detailOf(c, subject, curve), type::kSmall.with(inks.quiet));
    }
}

/// What the reference cannot tell.
void drawFloor(Canvas& canvas, const LogPlot& plot, double floor, const PlotInks& inks) {
    if (!(floor > plot.bottom())) return;
    const double y = plot.at(plot.left(), floor).y();
    canvas.fillRect({plot.area.left(), y, plot.area.width(), plot.area.bottom() - y}, inks.shade);
    canvas.text(plot.area.left() + 2, std::min(y + 4, plot.area.bottom() - 1.5), line("below the reference's own noise, " + formatPercent(floor)), type::kSmall.with(inks.quiet));
}

}  // namespace

QColor colourOf(const Comparison& comparison, const std::string& algorithm, const PlotInks& inks) {
    const auto at = std::ranges::find(comparison.algorithms, algorithm, &ComparedAlgorithm::name) - comparison.algorithms.begin();
    const auto& colour = kColours[static_cast<std::size_t>(at) % kColours.size()];
    if (!inks.onDark) return colour;
    return colour.lightness() < 40 ? inks.text : colour.lightness() < 110 ? colour.lighter(150) : colour;
}

QString slopeText(const ComparedSlope& slope) {
    if (!std::isfinite(slope.ci95)) return "–";
    const auto size = fmt::format("{:.2f}", std::abs(slope.slope));
    return line((slope.slope < 0 && size != "0.00" ? "−" : "") + fmt::format("{} ± {:.2f}", size, slope.ci95));
}

QString referenceText(const ComparedReference& r) {
    return line(fmt::format("{} {}; reference by {}, known to ± {} (95 %)", formatCount(r.values), r.picture ? "pixels" : "points", r.algorithm, formatPercent(r.relativeError)));
}

std::vector<PlottedRun> plottedRuns(const QRectF& area, const Comparison& c, const ComparedReference& reference) {
    const auto curves = curvesOf(c, reference.subject);
    if (curves.empty()) return {};
    const auto plot = frameOf(innerOf(area), curves, reference.relativeError / kSigma95);
    std::vector<PlottedRun> out;
    for (const auto& curve : curves)
        for (const auto* run : curve.runs) out.push_back({run, plot.at(run->seconds, run->rms.value_or(run->rmsAtMost))});
    return out;
}

void drawErrorCurves(Canvas& canvas, const QRectF& area, const Comparison& c, const ComparedReference& reference, const PlotInks& inks) {
    const auto curves = curvesOf(c, reference.subject);
    if (curves.empty()) {
        canvas.text(area.left(), area.top() + 6, "No run was finished: there is nothing to plot.", type::kBody.with(inks.text));
        return;
    }
    const double floor = reference.relativeError / kSigma95;
    const auto inner = innerOf(area);
    const auto plot = frameOf(inner, curves, floor);
    drawFloor(canvas, plot, floor, inks);
    const QString below = c.coreTime ? "Run time in core seconds, preparation included" : "Run time in s, preparation included";
    drawLogAxes(canvas, plot, below, "Root mean square error relative to the value, in %", inks);
    const auto* guide = curves.front().runs.front();  // through the first run of the first algorithm
    drawHalfSlope(canvas, plot, guide->seconds, guide->rms.value_or(guide->rmsAtMost), inks);
    for (std::size_t i = curves.size(); i-- > 0;) drawCurve(canvas, plot, curves[i], colourOf(c, curves[i].algorithm, inks));
    drawLabels(canvas, plot, c, reference.subject, curves, inks);
    canvas.stroke(inner.left(), area.bottom() - 2.3, inner.left() + 7, area.bottom() - 2.3, inks.quiet, 0.25, Qt::DashLine);
    // Beside the axis' title, as much as there is room for.
    QString words = "slope −1/2: noise alone";
    if (canvas.textWidth(words, type::kSmall) + canvas.textWidth(below, type::kLabel) > inner.width() - 13) words = "slope −1/2";
    canvas.text(inner.left() + 9, area.bottom() - 1.4, words, type::kSmall.with(inks.quiet));
}

}  // namespace luxdeck::report
