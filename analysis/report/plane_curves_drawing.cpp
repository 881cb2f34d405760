#include "analysis/report/number_format.h"
#include "analysis/report/photometric_drawing.h"
#include "tonemap/colour_map.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace luxdeck::report {

namespace {

constexpr int kStepsPerDegree = 4;      // finer than any file's own angles in the lobe of a spot
constexpr double kDark = 0.01;          // of the maximum: gammas with less are left out at the ends
constexpr double kSame = 0.01;          // of the maximum: planes that differ by less share a curve
constexpr int kPlaneStep = 30;          // degrees

struct PlaneCurve {
    std::vector<int> planes;            // degrees of C; they share the curve
    std::vector<double> candela;        // over gamma 0..180, kStepsPerDegree a degree
};

double difference(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// Every kPlaneStep degrees, and the plane of the maximum, which may lie between.
std::vector<int> planesOf(const CandelaTable& table) {
    std::vector<int> planes;
    for (int plane = 0; plane < 360; plane += kPlaneStep) planes.push_back(plane);
    const int most = static_cast<int>(std::lround(peakDirection(table).planeDegrees)) % 360;
    if (most % kPlaneStep != 0) planes.insert(std::upper_bound(planes.begin(), planes.end(), most), most);
    return planes;
}

std::vector<PlaneCurve> curvesOf(const CandelaTable& table, double peak) {
    std::vector<PlaneCurve> curves;
    for (const int plane : planesOf(table)) {
        std::vector<double> candela;
        for (int i = 0; i <= 180 * kStepsPerDegree; ++i)
            candela.push_back(intensityAt(table, plane, static_cast<double>(i) / kStepsPerDegree));
        const auto same = std::find_if(curves.begin(), curves.end(),
                                       [&](const PlaneCurve& c) { return difference(c.candela, candela) <= kSame * peak; });
        if (same != curves.end()) same->planes.push_back(plane);
        else curves.push_back({{plane}, std::move(candela)});
    }
    return curves;
}

struct GammaRange {
    int from = 0, to = 180, step = 30;
};

/// Round ends about the gammas that have light.
GammaRange rangeOf(const std::vector<PlaneCurve>& curves, double peak) {
    std::size_t first = 180 * kStepsPerDegree, last = 0;
    for (const auto& c : curves)
        for (std::size_t i = 0; i < c.candela.size(); ++i)
            if (c.candela[i] > kDark * peak) first = std::min(first, i), last = std::max(last, i);
    if (first > last) return {};
    const double low = static_cast<double>(first) / kStepsPerDegree, high = static_cast<double>(last) / kStepsPerDegree;
    GammaRange range;
    const double span = high - low;
    range.step = span <= 8 ? 1 : span <= 16 ? 2 : span <= 45 ? 5 : span <= 60 ? 10 : span <= 100 ? 15 : 30;
    range.from = static_cast<int>(std::floor(low / range.step)) * range.step;
    range.to = std::min(180, static_cast<int>(std::ceil(high / range.step)) * range.step);
    if (range.to - range.from < 2 * range.step) range.to = range.from + 2 * range.step;
    return range;
}

/// From dark to bright without the colours that paper does not show.
QColor colourOf(std::size_t index, std::size_t count) {
    if (count == 1) return ink::kAccent;
    const auto c = tonemap::colourAt(tonemap::ColourMap::Dusk, 0.12 + 0.66 * static_cast<double>(index) / static_cast<double>(count - 1));
    return {c[0], c[1], c[2]};
}

QString legendText(const PlaneCurve& curve, std::size_t curves) {
    if (curves == 1) return "All C planes";
    QStringList names;
    for (const int plane : curve.planes) names << QString("C%1").arg(plane);
    return names.join(", ");
}

/// Rows of the legend below the plot; returns their height when `draw` is false too.
double legend(Canvas& canvas, const QRectF& area, double top, const std::vector<PlaneCurve>& curves, bool draw) {
    const double rowMm = Canvas::lineHeight(type::kSmall) + 0.8;
    double x = area.left(), y = top + rowMm;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const auto text = legendText(curves[i], curves.size());
        const double width = 8 + canvas.textWidth(text, type::kSmall) + 5;
        if (x > area.left() && x + width > area.right()) x = area.left(), y += rowMm;
        if (draw) {
            canvas.stroke(x, y - 1, x + 6, y - 1, colourOf(i, curves.size()), 0.7);
            canvas.text(x + 8, y, text, type::kSmall.with(ink::kBlack));
        }
        x += width;
    }
    return y - top + 1;
}

struct PlotFrame {
    QRectF box;
    GammaRange gamma;
    double top = 1;
    [[nodiscard]] double x(double degrees) const { return box.left() + box.width() * (degrees - gamma.from) / (gamma.to - gamma.from); }
    [[nodiscard]] double y(double candela) const { return box.bottom() - box.height() * candela / top; }
};

void drawAxes(Canvas& canvas, const PlotFrame& frame, const AxisSteps& steps, double peak) {
    const auto right = type::kLabel.aligned(Align::Right), centre = type::kLabel.aligned(Align::Centre);
    for (int i = 0; i <= steps.count; ++i) {
        const double y = frame.y(steps.step * i);
        canvas.stroke(frame.box.left(), y, frame.box.right(), y, i == 0 ? ink::kBlack : ink::kLight, i == 0 ? 0.3 : 0.15);
        canvas.text(frame.box.left() - 1.8, y + Canvas::capHeight(right) / 2, line(formatNumber(steps.step * i)), right);
    }
    for (int g = frame.gamma.from; g <= frame.gamma.to; g += frame.gamma.step) {
        const double x = frame.x(g);
        canvas.stroke(x, frame.box.top(), x, frame.box.bottom(), ink::kLight, 0.15);
        canvas.text(x, frame.box.bottom() + 4.2, QString("%1°").arg(g), centre);
    }
    for (const auto& [share, name] : {std::pair{0.5, "50 %"}, std::pair{0.1, "10 %"}}) {
        const double y = frame.y(share * peak);
        canvas.stroke(frame.box.left(), y, frame.box.right(), y, ink::kGrey, 0.2, Qt::DashLine);
        canvas.text(frame.box.right() + 1.5, y + Canvas::capHeight(type::kLabel) / 2, name, type::kLabel);
    }
}

void drawCurve(Canvas& canvas, const PlotFrame& frame, const PlaneCurve& curve, QColor colour) {
    QPolygonF points;
    for (int i = frame.gamma.from * kStepsPerDegree; i <= frame.gamma.to * kStepsPerDegree; ++i)
        points << QPointF(frame.x(static_cast<double>(i) / kStepsPerDegree), frame.y(curve.candela[static_cast<std::size_t>(i)]));
    canvas.polyline(points, colour, 0.5);
}

}  // namespace

void drawPlaneCurves(Canvas& canvas, const QRectF& area, const CandelaTable& table) {
    const double peak = table.maxIntensity();
    const auto curves = curvesOf(table, peak);
    const auto steps = axisSteps(peak);
    double numbers = 0;
    for (int i = 0; i <= steps.count; ++i)
        numbers = std::max(numbers, canvas.textWidth(line(formatNumber(steps.step * i)), type::kLabel));
    const double below = legend(canvas, area, 0, curves, false);
    constexpr double kTopMm = 3, kRightMm = 10, kAxisMm = 7;
    const PlotFrame frame{{area.left() + numbers + 2, area.top() + kTopMm, area.width() - numbers - 2 - kRightMm,
                           area.height() - kTopMm - kAxisMm - below},
                          rangeOf(curves, peak), steps.top()};
    drawAxes(canvas, frame, steps, peak);
    for (std::size_t i = curves.size(); i-- > 0;) drawCurve(canvas, frame, curves[i], colourOf(i, curves.size()));
    legend(canvas, area, area.bottom() - below, curves, true);
}

}  // namespace luxdeck::report
