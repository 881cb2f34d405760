#include "gui/view3d/view_overlay.h"

#include "gui/view3d/annotation_painter.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <utility>

namespace luxdeck::gui {

ViewOverlay::ViewOverlay(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setObjectName(QStringLiteral("viewOverlay"));
}

void ViewOverlay::setAnnotations(std::vector<Annotation> annotations, std::vector<std::uint8_t> seen) {
    annotations_ = std::move(annotations);
    seen_ = std::move(seen);
    update();
}

void ViewOverlay::setPose(const CameraPose& pose) {
    pose_ = pose;
    update();
}

void ViewOverlay::setColours(const ViewColours& colours) {
    colours_ = colours;
    update();
}

void ViewOverlay::setFramed(bool framed) {
    if (framed == framed_) return;
    framed_ = framed;
    update();
}

void ViewOverlay::setHint(const QString& hint) {
    if (hint == hint_) return;
    hint_ = hint;
    update();
}

void ViewOverlay::setReading(const QString& reading, QPoint at) {
    if (reading.isEmpty() && reading_.isEmpty()) return;
    reading_ = reading;
    readingAt_ = at;
    update();
}

std::optional<QPointF> ViewOverlay::pixelOf(const Vec3d& point) const {
    const auto seen = seenAt(pose_, static_cast<double>(width()) / std::max(height(), 1), point);
    if (!seen) return {};
    return QPointF((seen->x + 1) / 2 * width(), (1 - seen->y) / 2 * height());
}

void ViewOverlay::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintAnnotations(painter);
    if (painter_) painter_(painter);
    paintAxes(painter);
    paintHint(painter);
    paintReading(painter);
    if (!framed_) return;
    painter.setPen(QPen(colours_.accent, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
}

void ViewOverlay::paintAnnotations(QPainter& painter) const {
    AnnotationPainter texts(painter, rect(), colours_);
    // What is selected first, surfaces before the numbers on them: room goes to what matters.
    const auto pass = [&](Annotation::Kind kind, bool strong) {
        for (std::size_t i = 0; i < annotations_.size(); ++i) {
            const auto& a = annotations_[i];
            if (a.kind != kind || a.strong != strong || (i < seen_.size() && seen_[i] == 0 && !strong)) continue;
            if (const auto at = pixelOf(a.at)) texts.paint(a, *at);
        }
    };
    using Kind = Annotation::Kind;
    for (const bool strong : {true, false})
        for (const auto kind : {Kind::Surface, Kind::Mark, Kind::Isoline, Kind::Value}) pass(kind, strong);
}

/// A cross of the three axes in a corner: where east, north and up are.
void ViewOverlay::paintAxes(QPainter& painter) const {
    const QPointF origin(44, height() - 44);
    constexpr double kLength = 26;
    struct Axis {
        const char* name;
        Vec3d direction;
        QColor colour;
    };
    std::array<Axis, 3> axes{{{"X", {1, 0, 0}, QColor(214, 69, 65)}, {"Y", {0, 1, 0}, QColor(74, 160, 72)}, {"Z", {0, 0, 1}, QColor(64, 120, 216)}}};
    std::sort(axes.begin(), axes.end(), [&](const Axis& a, const Axis& b) { return a.direction.dot(pose_.direction) > b.direction.dot(pose_.direction); });
    QFont font = painter.font();
    font.setPixelSize(11);
    font.setBold(true);
    painter.setFont(font);
    for (const auto& axis : axes) {
        const QPointF tip = origin + QPointF(axis.direction.dot(pose_.right()), -axis.direction.dot(pose_.up)) * kLength;
        painter.setPen(QPen(axis.colour, 2.2, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(origin, tip);
        painter.setPen(Qt::NoPen);
        painter.setBrush(axis.colour);
        painter.drawEllipse(tip, 7.5, 7.5);
        painter.setPen(Qt::white);
        painter.drawText(QRectF(tip - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter, QLatin1String(axis.name));
    }
}

void ViewOverlay::paintHint(QPainter& painter) const {
    if (hint_.isEmpty()) return;
    const QSizeF size(painter.fontMetrics().horizontalAdvance(hint_) + 24, painter.fontMetrics().height() + 10);
    const QRectF box(QPointF((width() - size.width()) / 2, height() - size.height() - 12), size);
    painter.setPen(Qt::NoPen);
    QColor paper = colours_.paper;
    paper.setAlphaF(0.82);
    painter.setBrush(paper);
    painter.drawRoundedRect(box, box.height() / 2, box.height() / 2);
    painter.setPen(colours_.ink);
    painter.drawText(box, Qt::AlignCenter, hint_);
}

void ViewOverlay::paintReading(QPainter& painter) const {
    if (reading_.isEmpty()) return;
    QRectF text = painter.boundingRect(QRectF(0, 0, 320, 200), Qt::AlignLeft, reading_);
    QRectF box = text.adjusted(-9, -6, 9, 6);
    box.moveTopLeft(QPointF(readingAt_) + QPointF(16, 18));
    if (box.right() > width() - 4) box.moveRight(readingAt_.x() - 12);
    if (box.bottom() > height() - 4) box.moveBottom(readingAt_.y() - 10);
    painter.setPen(QPen(QColor(0, 0, 0, 40), 1));
    QColor paper = colours_.paper;
    paper.setAlphaF(0.93);
    painter.setBrush(paper);
    painter.drawRoundedRect(box, 5, 5);
    painter.setPen(colours_.ink);
    painter.drawText(box.adjusted(9, 6, -9, -6), Qt::AlignLeft, reading_);
}

}  // namespace luxdeck::gui
