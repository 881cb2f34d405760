#include "analysis/report/number_format.h"
#include "analysis/report/photometric_drawing.h"

#include "engine/core/units.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace luxdeck::report {

namespace {

constexpr double kDark = 0.01;       // of the maximum: a hemisphere with less has no light
constexpr double kSame = 0.01;       // of the maximum: planes that differ by less are drawn as one
constexpr double kAngleMarginMm = 8; // for the angles' labels
constexpr double kLegendMm = 9;

/// Where the nadir points down and a radius of 1 is the outermost ring.
struct PolarFrame {
    QPointF centre;
    double radiusMm = 1;
    double top = 1;      // intensity of the outermost ring [cd]
    bool upper = true, lower = true;

    [[nodiscard]] QPointF at(double degrees, double share) const {
        const double a = degrees * kDegree;
        return {centre.x() + radiusMm * share * std::sin(a), centre.y() + radiusMm * share * std::cos(a)};
    }
    [[nodiscard]] bool shows(double degrees) const {
        const double gamma = std::abs(degrees);
        return gamma == 90 || (gamma < 90 ? lower : upper);
    }
};

double largest(const PolarCurve& c) {
    double most = 0;
    for (const auto* side : {&c.c0, &c.c90})
        for (const double v : *side) most = std::max(most, v);
    return most;
}

/// The most light on one side of the horizontal.
double largestIn(const PolarCurve& c, bool upper) {
    double most = 0;
    const int half = PolarCurve::kStepsPerTurn / 2;
    for (int i = -half; i <= half; ++i) {
        if ((std::abs(i) > 90) != upper || std::abs(i) == 90) continue;
        const auto k = static_cast<std::size_t>(i + half);
        most = std::max({most, c.c0[k], c.c90[k]});
    }
    return most;
}

bool planesAgree(const PolarCurve& c) {
    const double allowed = kSame * largest(c);
    for (std::size_t i = 0; i < c.c0.size(); ++i)
        if (std::abs(c.c0[i] - c.c90[i]) > allowed) return false;
    return true;
}

PolarFrame frameOf(const QRectF& area, const PolarCurve& curve, const AxisSteps& rings) {
    PolarFrame frame;
    const double most = largest(curve), margin = kAngleMarginMm;
    frame.upper = largestIn(curve, true) > kDark * most;
    frame.lower = largestIn(curve, false) > kDark * most || !frame.upper;
    frame.top = rings.top();
    const double width = area.width() - 2 * margin, height = area.height() - 2 * margin - kLegendMm;
    const bool both = frame.upper && frame.lower;
    frame.radiusMm = std::min(width / 2, both ? height / 2 : height);
    const double used = both ? 2 * frame.radiusMm : frame.radiusMm;
    const double top = area.top() + margin + (height - used) / 2;
    frame.centre = {area.center().x(), frame.lower && !frame.upper ? top : top + frame.radiusMm};
    return frame;
}

void drawArc(Canvas& canvas, const PolarFrame& frame, double share, QColor colour, double widthMm) {
    QPolygonF points;
    const int start = frame.lower ? (frame.upper ? -180 : -90) : 90, end = frame.lower ? (frame.upper ? 180 : 90) : 270;
    for (int a = start; a <= end; a += 2) points << frame.at(a, share);
    canvas.polyline(points, colour, widthMm);
}

void drawGround(Canvas& canvas, const PolarFrame& frame, const AxisSteps& rings) {
    for (int i = 1; i <= rings.count; ++i)
        drawArc(canvas, frame, static_cast<double>(i) / rings.count, ink::kLight, i == rings.count ? 0.3 : 0.15);
    for (int a = -180; a < 180; a += 15) {
        if (!frame.shows(a)) continue;
        const QPointF end = frame.at(a, 1);
        canvas.stroke(frame.centre.x(), frame.centre.y(), end.x(), end.y(), ink::kLight, a % 90 == 0 ? 0.3 : 0.15);
    }
}

QPolygonF outline(const PolarFrame& frame, const std::vector<double>& candela) {
    QPolygonF points;
    const int half = PolarCurve::kStepsPerTurn / 2;
    for (int i = -half; i <= half; ++i) {
        // The dark hemisphere is not drawn, so what little is there must not stick out of the picture.
        const double share = frame.shows(i) ? candela[static_cast<std::size_t>(i + half)] / frame.top : 0;
        points << frame.at(i, share);
    }
    return points;
}

void drawCurves(Canvas& canvas, const PolarFrame& frame, const PolarCurve& curve, bool one) {
    const auto c0 = outline(frame, curve.c0);
    QColor tint = ink::kAccent;
    tint.setAlpha(26);
    canvas.fill(c0, tint);
    if (!one) canvas.polyline(outline(frame, curve.c90), ink::kBlack, 0.5, Qt::DashLine);
    canvas.polyline(c0, ink::kAccent, 0.6);
}

struct RingNumber {
    QString text;
    QRectF box;
};

std::vector<RingNumber> ringNumbers(const Canvas& canvas, const PolarFrame& frame, const AxisSteps& rings, double spoke) {
    std::vector<RingNumber> out;
    for (int i = 1; i <= rings.count; ++i) {
        const bool outermost = i == rings.count;
        const auto number = line(formatNumber(rings.step * i) + (outermost ? " cd" : ""));
        const double width = canvas.textWidth(number, type::kLabel) + 1.2, height = Canvas::capHeight(type::kLabel) + 1.4;
        const double a = std::abs(spoke) * kDegree;  // the outermost number stays inside its ring
        const double inset = outermost ? (width / 2 * std::sin(a) + height / 2 * std::abs(std::cos(a))) / frame.radiusMm : 0;
        const auto at = frame.at(spoke, static_cast<double>(i) / rings.count - inset);
        out.push_back({number, {at.x() - width / 2, at.y() - height / 2, width, height}});
    }
    return out;
}

/// How far the nearest point of a curve is from the nearest number [mm]; negative inside one.
double clearance(const std::vector<RingNumber>& numbers, const std::vector<QPolygonF>& curves) {
    double least = 1e9;
    for (const auto& number : numbers) {
        const QPointF centre = number.box.center();
        for (const auto& curve : curves)
            for (const auto& p : curve)
                least = std::min(least, std::max(std::abs(p.x() - centre.x()) - number.box.width() / 2,
                                                 std::abs(p.y() - centre.y()) - number.box.height() / 2));
    }
    return least;
}

/// Every ring's number on one spoke, where the curves leave most room.
void drawRingNumbers(Canvas& canvas, const PolarFrame& frame, const PolarCurve& curve, const AxisSteps& rings) {
    const std::vector<QPolygonF> curves{outline(frame, curve.c0), outline(frame, curve.c90)};
    std::vector<RingNumber> best;
    double room = -1e9;
    for (int spoke = 0; spoke <= 345; spoke += 5) {
        const int angle = spoke <= 180 ? spoke : spoke - 360;
        const int fromAngle = spoke % 30;  // the angles' own numbers stand at every 30 degrees
        if (!frame.shows(angle) || fromAngle < 10 || fromAngle > 20) continue;
        auto numbers = ringNumbers(canvas, frame, rings, angle);
        const double here = clearance(numbers, curves);
        if (here > room + 0.05) room = here, best = std::move(numbers);
    }
    const auto style = type::kLabel.with(ink::kBlack).aligned(Align::Centre);
    for (const auto& [text, box] : best) {
        canvas.fillRect(box, ink::kWhite);
        canvas.text(box.center().x(), box.center().y() + Canvas::capHeight(style) / 2, text, style);
    }
}

void drawAngles(Canvas& canvas, const PolarFrame& frame) {
    const auto style = type::kLabel.aligned(Align::Centre);
    for (int a = -150; a <= 180; a += 30) {
        if (!frame.shows(a)) continue;
        const auto on = frame.at(a, 1 + 4.4 / frame.radiusMm);
        canvas.text(on.x(), on.y() + Canvas::capHeight(style) / 2, QString("%1°").arg(std::abs(a)), style);
    }
}

void drawLegend(Canvas& canvas, const QRectF& area, bool one) {
    const double y = area.bottom() - 2.5;
    const auto entry = [&](double x, const QString& text, QColor colour, Qt::PenStyle pen) {
        canvas.stroke(x, y - 1, x + 8, y - 1, colour, 0.6, pen);
        canvas.text(x + 10, y, text, type::kBody);
        return x + 10 + canvas.textWidth(text, type::kBody) + 8;
    };
    const QString first = one ? "C0–C180 and C90–C270 alike" : "C0–C180", second = "C90–C270";
    const double width = one ? canvas.textWidth(first, type::kBody) + 10
                             : canvas.textWidth(first, type::kBody) + canvas.textWidth(second, type::kBody) + 28;
    const double next = entry(area.center().x() - width / 2, first, ink::kAccent, Qt::SolidLine);
    if (!one) entry(next, second, ink::kBlack, Qt::DashLine);
}

}  // namespace

AxisSteps axisSteps(double maximum) {
    if (!(maximum > 0) || !std::isfinite(maximum)) return {};
    const double raw = maximum / 5, power = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        if (raw <= factor * power * (1 + 1e-9)) step = factor * power;
    return {step, std::max(1, static_cast<int>(std::ceil(maximum / step * (1 - 1e-9))))};
}

void drawPolar(Canvas& canvas, const QRectF& area, const PolarCurve& curve) {
    const bool one = planesAgree(curve);
    const double most = largest(curve);
    const auto rings = axisSteps(most);
    const auto frame = frameOf(area, curve, rings);
    drawGround(canvas, frame, rings);
    drawAngles(canvas, frame);
    if (most > 0) drawCurves(canvas, frame, curve, one);
    if (most > 0) drawRingNumbers(canvas, frame, curve, rings);
    drawLegend(canvas, area, one);
}

}  // namespace luxdeck::report
