#include "analysis/report/log_plot.h"

#include "analysis/report/number_format.h"

#include <cmath>
#include <vector>

namespace luxdeck::report {

namespace {

constexpr double kNumbersMm = 11;  // left of the axis, where its title begins

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

}  // namespace

QPointF LogPlot::at(double x, double y) const {
    return {area.left() + area.width() * (std::log10(x) - x0) / (x1 - x0), area.bottom() - area.height() * (std::log10(y) - y0) / (y1 - y0)};
}
double LogPlot::left() const { return std::pow(10.0, x0); }
double LogPlot::right() const { return std::pow(10.0, x1); }
double LogPlot::bottom() const { return std::pow(10.0, y0); }
double LogPlot::top() const { return std::pow(10.0, y1); }

LogPlot logPlotOf(const QRectF& area, double xLow, double xHigh, double yLow, double yHigh) {
    roundLog(xLow, xHigh);
    roundLog(yLow, yHigh);
    return {area, std::log10(xLow), std::log10(xHigh), std::log10(yLow), std::log10(yHigh)};
}

void drawLogAxes(Canvas& canvas, const LogPlot& plot, const QString& below, const QString& above, const PlotInks& inks) {
    const TextStyle label{7, QFont::Normal, inks.quiet};
    for (const double t : logTicks(plot.x0, plot.x1)) {
        const auto p = plot.at(t, plot.bottom());
        canvas.stroke(p.x(), plot.area.top(), p.x(), p.y(), inks.hairline, 0.15);
        canvas.text(p.x(), p.y() + 4, line(formatNumber(t, 2)), label.aligned(Align::Centre));
    }
    for (const double e : logTicks(plot.y0, plot.y1)) {
        const auto p = plot.at(plot.left(), e);
        canvas.stroke(p.x(), p.y(), plot.area.right(), p.y(), inks.hairline, 0.15);
        canvas.text(p.x() - 1.6, p.y() + 0.9, line(formatNumber(e * 100, 2)), label.aligned(Align::Right));
    }
    canvas.stroke(plot.area.left(), plot.area.bottom(), plot.area.right(), plot.area.bottom(), inks.text, 0.3);
    canvas.stroke(plot.area.left(), plot.area.top(), plot.area.left(), plot.area.bottom(), inks.text, 0.3);
    canvas.text(plot.area.right(), plot.area.bottom() + 8.5, below, type::kLabel.with(inks.quiet).aligned(Align::Right));
    canvas.text(plot.area.left() - kNumbersMm, plot.area.top() - 4, above, type::kLabel.with(inks.quiet));
}

void drawHalfSlope(Canvas& canvas, const LogPlot& plot, double seconds, double error, const PlotInks& inks) {
    const auto at = [&](double t) { return plot.at(t, error * std::sqrt(seconds / t)); };
    canvas.clip(plot.area);
    canvas.polyline(QPolygonF(QVector<QPointF>{at(plot.left()), at(plot.right())}), inks.quiet, 0.25, Qt::DashLine);
    canvas.unclip();
}

}  // namespace luxdeck::report
