#include "gui/panels/colour_bar.h"

#include "gui/panels/text.h"
#include "tonemap/colour_map.h"
#include "tonemap/isolines.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

ColourBar::ColourBar(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Scale of the colours"));
}

void ColourBar::show(tonemap::ColourMap map, const tonemap::ScaleRange& range, bool logarithmic, const QString& unit) {
    map_ = map, range_ = range, logarithmic_ = logarithmic, unit_ = unit;
    update();
}

void ColourBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    auto letters = font();
    letters.setPointSizeF(letters.pointSizeF() * 0.85);
    painter.setFont(letters);
    const QFontMetricsF metrics(letters);
    constexpr int kSteps = 256;
    QImage colours(kSteps, 1, QImage::Format_RGB32);
    for (int i = 0; i < kSteps; ++i) {
        const auto c = tonemap::colourAt(map_, (i + 0.5) / kSteps);
        colours.setPixel(i, 0, qRgb(c[0], c[1], c[2]));
    }
    const QRectF bar(14, 3, width() - 28, 14);
    painter.drawImage(bar, colours);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    double free = 0;  // where the last number ended
    for (const double value : tonemap::roundLevels(range_.low, range_.high, 6, logarithmic_)) {
        const double t = logarithmic_ ? std::log(value / range_.low) / std::log(range_.high / range_.low) : (value - range_.low) / (range_.high - range_.low);
        const double x = bar.left() + bar.width() * t;
        painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 3));
        const auto text = qt(tonemap::labelOf(value));
        const double half = metrics.horizontalAdvance(text) / 2;
        const double middle = std::clamp(x, half, width() - half);
        if (middle - half < free) continue;
        painter.drawText(QRectF(middle - half, bar.bottom() + 4, 2 * half + 1, metrics.height()), Qt::AlignCenter, text);
        free = middle + half + 4;
    }
    painter.drawText(QRectF(0, bar.bottom() + 4 + metrics.height(), width(), metrics.height()), Qt::AlignCenter, unit_);
}

}  // namespace luxdeck::gui
