#include "gui/panels/tone_histogram.h"

#include "gui/panels/text.h"
#include "tonemap/falsecolor.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

/// The plot, and decimal logarithms at its ends.
struct ToneHistogram::Frame {
    QRectF area;
    double x0 = 0, x1 = 1, y0 = 0, y1 = 1;

    [[nodiscard]] double x(double log10World) const { return area.left() + area.width() * (log10World - x0) / (x1 - x0); }
    [[nodiscard]] double y(double log10Display) const { return area.bottom() - area.height() * (log10Display - y0) / (y1 - y0); }
};

namespace {

QColor quiet(const QPalette& palette) { return palette.color(QPalette::PlaceholderText); }

QFont small(const QFont& font) {
    auto out = font;
    out.setPointSizeF(font.pointSizeF() * 0.85);
    return out;
}

}  // namespace

ToneHistogram::ToneHistogram(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Histogram of luminance with the curve to the display"));
    setToolTip(tr("Bars: how much of the picture has which luminance. Curve: what it is shown as on the display. Both axes are logarithmic."));
}

void ToneHistogram::show(std::shared_ptr<const Developed> picture, const Units& units) {
    picture_ = std::move(picture);
    units_ = units;
    update();
}

void ToneHistogram::mark(double cdM2) {
    if (cdM2 == marked_) return;
    marked_ = cdM2;
    update();
}

void ToneHistogram::drawBars(QPainter& painter, const Frame& frame) const {
    const auto& h = picture_->histogram;
    const double most = *std::max_element(h.counts.begin(), h.counts.end());
    if (!(most > 0)) return;
    auto colour = palette().color(QPalette::Highlight);
    colour.setAlpha(95);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    const auto edge = [&](std::size_t bin) { return frame.x((h.minLog + static_cast<double>(bin) * h.binWidth()) / std::log(10.0)); };
    QPainterPath outline;
    outline.moveTo(edge(0), frame.area.bottom());
    for (std::size_t i = 0; i < h.counts.size(); ++i) {
        // Square roots: what is rare (a lamp) is seen beside what is common (a wall).
        const double y = frame.area.bottom() - frame.area.height() * std::sqrt(h.counts[i] / most);
        outline.lineTo(edge(i), y);
        outline.lineTo(edge(i + 1), y);
    }
    outline.lineTo(edge(h.counts.size()), frame.area.bottom());
    painter.drawPath(outline);
}

void ToneHistogram::drawAxes(QPainter& painter, const Frame& frame) const {
    painter.setFont(small(font()));
    const QFontMetricsF metrics(painter.font());
    const auto line = palette().color(QPalette::Mid);
    for (double decade = std::ceil(frame.x0 - 1e-9); decade <= frame.x1 + 1e-9; ++decade) {
        const double x = frame.x(decade);
        painter.setPen(line);
        painter.drawLine(QPointF(x, frame.area.top()), QPointF(x, frame.area.bottom()));
        painter.setPen(quiet(palette()));
        painter.drawText(QRectF(x - 30, frame.area.bottom() + 2, 60, metrics.height()), Qt::AlignCenter, qt(tonemap::labelOf(std::pow(10.0, decade))));
    }
    painter.setPen(line);
    painter.drawLine(frame.area.bottomLeft(), frame.area.bottomRight());
    painter.setPen(quiet(palette()));
    const auto unit = qt(units_.luminanceUnit());
    painter.drawText(QRectF(frame.area.left(), height() - metrics.height() - 1, frame.area.width(), metrics.height()), Qt::AlignCenter, tr("luminance in the room, %1").arg(unit));
    if (!picture_->record) return;
    const double top = std::pow(10.0, frame.y1), bottom = std::pow(10.0, frame.y0);
    for (const double value : {bottom, std::sqrt(top * bottom), top})
        painter.drawText(QRectF(0, frame.y(std::log10(value)) - metrics.height() / 2, frame.area.left() - 5, metrics.height()), Qt::AlignRight | Qt::AlignVCenter, qt(numberText(value)));
    painter.drawText(QRectF(0, 0, width(), metrics.height()), Qt::AlignLeft, tr("shown, %1").arg(unit));
}

void ToneHistogram::drawCurve(QPainter& painter, const Frame& frame) const {
    QPolygonF curve;
    for (const auto& p : picture_->record->curve)
        if (p.worldCdM2 > 0 && p.displayCdM2 > 0)
            curve << QPointF(frame.x(std::log10(units_.luminance(p.worldCdM2))), frame.y(std::log10(units_.luminance(p.displayCdM2))));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(frame.area.adjusted(0, -1, 0, 1));
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1.8));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(curve);
    painter.setClipping(false);
}

void ToneHistogram::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (!picture_ || picture_->histogram.counts.empty()) {
        painter.setPen(quiet(palette()));
        painter.drawText(rect(), Qt::AlignCenter, tr("No picture yet"));
        return;
    }
    const QFontMetricsF metrics(small(font()));
    Frame frame;
    const double scale = units_.luminance(1);
    frame.x0 = picture_->histogram.minLog / std::log(10.0) + std::log10(scale), frame.x1 = picture_->histogram.maxLog / std::log(10.0) + std::log10(scale);
    if (picture_->record) frame.y0 = std::log10(units_.luminance(picture_->record->display.minCdM2)), frame.y1 = std::log10(units_.luminance(picture_->record->display.maxCdM2));
    const double left = picture_->record ? metrics.horizontalAdvance(QStringLiteral("0.00")) + 8 : 4;
    frame.area = QRectF(left, metrics.height() + 4, width() - left - 8, height() - 3 * metrics.height() - 10);
    drawAxes(painter, frame);
    // The histogram's frame is in the units shown; its bins are in cd/m².
    Frame bins = frame;
    bins.x0 -= std::log10(scale), bins.x1 -= std::log10(scale);
    drawBars(painter, bins);
    if (picture_->record) drawCurve(painter, frame);
    if (marked_ > 0) {
        painter.setPen(QPen(palette().color(QPalette::WindowText), 1, Qt::DotLine));
        const double x = std::clamp(bins.x(std::log10(marked_)), frame.area.left(), frame.area.right());
        painter.drawLine(QPointF(x, frame.area.top()), QPointF(x, frame.area.bottom()));
    }
}

}  // namespace luxdeck::gui
