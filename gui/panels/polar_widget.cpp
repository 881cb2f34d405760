#include "gui/panels/polar_widget.h"

#include "analysis/report/photometric_drawing.h"

#include <QPainter>

namespace luxdeck::gui {

PolarWidget::PolarWidget(const CandelaTable& table, QWidget* parent) : QWidget(parent), curve_(polarCurve(table)) {
    setObjectName(QStringLiteral("polarCurve"));
    setMinimumHeight(240);
    setAccessibleName(tr("Polar curve"));
    setToolTip(tr("Intensity: C0-C180 solid, C90-C270 dashed"));
}

void PolarWidget::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(report::ink::kWhite);
    painter.drawRoundedRect(rect(), 6, 6);
    constexpr double kOfPaper = 0.75;  // smaller than in print: a panel is narrow, and read from nearer
    const double dots = kOfPaper * logicalDpiX() / 25.4;  // of a millimetre
    report::Canvas canvas(painter, dots, report::reportFontFamily());
    constexpr double kMarginMm = 2;
    report::drawPolar(canvas, {kMarginMm, kMarginMm, width() / dots - 2 * kMarginMm, height() / dots - 2 * kMarginMm}, curve_);
}

}  // namespace luxdeck::gui
