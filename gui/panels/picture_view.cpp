#include "gui/panels/picture_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {
constexpr double kMostZoom = 32;       // screen dots a pixel
constexpr double kGripPx = 7;          // either side of the divider
constexpr double kSharpFrom = 2;       // zoom from which pixels are seen as squares
}  // namespace

PictureView::PictureView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Picture"));
}

void PictureView::setPicture(int side, const QImage& picture, const QString& name) {
    const auto s = static_cast<std::size_t>(side);
    if (pictures_[s].cacheKey() != picture.cacheKey()) scaled_[s] = {};
    pictures_[s] = picture;
    names_[s] = name;
    update();
}

void PictureView::setNominalSize(QSize size) {
    if (size == nominal_ || size.isEmpty()) return;
    nominal_ = size;
    fits_ ? fit() : place();
}

void PictureView::setDivider(double at) {
    divider_ = std::clamp(at, 0.0, 1.0);
    update();
}

void PictureView::fit() {
    fits_ = true;
    scale_ = std::min(width() / static_cast<double>(nominal_.width()), height() / static_cast<double>(nominal_.height()));
    place();
}

void PictureView::oneToOne() { zoomTo(1 / devicePixelRatioF(), QPointF(width(), height()) / 2); }

void PictureView::zoomTo(double scale, QPointF about) {
    const double least = std::min({1.0, width() / (2.0 * nominal_.width()), height() / (2.0 * nominal_.height())});
    scale = std::clamp(scale, least, kMostZoom / devicePixelRatioF());
    corner_ = about - (about - corner_) * (scale / scale_);
    scale_ = scale;
    fits_ = false;
    place();
}

/// Keeps the picture in the middle while it is smaller than the widget, and within reach while it is larger.
void PictureView::place() {
    const auto along = [](double corner, double picture, double room) {
        return picture <= room ? (room - picture) / 2 : std::clamp(corner, room - picture, 0.0);
    };
    corner_ = {along(corner_.x(), nominal_.width() * scale_, width()), along(corner_.y(), nominal_.height() * scale_, height())};
    emit zoomChanged();
    update();
}

QRectF PictureView::target() const { return {corner_, QSizeF(nominal_) * scale_}; }

double PictureView::dividerX() const {
    const auto seen = target().intersected(rect());
    return seen.left() + divider_ * seen.width();
}

bool PictureView::onDivider(QPointF at) const { return compares() && std::abs(at.x() - dividerX()) <= kGripPx; }

void PictureView::drawSide(QPainter& painter, int side) {
    const auto s = static_cast<std::size_t>(side);
    const auto& picture = pictures_[s];
    if (picture.isNull()) return;
    const auto area = target();
    const auto dots = (area.size() * devicePixelRatioF()).toSize();
    if (dots.width() <= picture.width()) {
        // Scaled once, well, and kept: dragging the divider only copies.
        if (scaled_[s].size() != dots) {
            scaled_[s] = QPixmap::fromImage(picture.scaled(dots, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
            scaled_[s].setDevicePixelRatio(devicePixelRatioF());
        }
        painter.drawPixmap(area.topLeft(), scaled_[s]);
        return;
    }
    const bool whole = picture.width() >= nominal_.width();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, fits_ || !whole || zoom() < kSharpFrom);
    painter.drawImage(area, picture);
}

void PictureView::drawDivider(QPainter& painter) {
    const auto seen = target().intersected(rect());
    const double x = dividerX(), middle = seen.center().y();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0, 0, 0, 90), 4));
    painter.drawLine(QPointF(x, seen.top()), QPointF(x, seen.bottom()));
    painter.setPen(QPen(Qt::white, 2));
    painter.drawLine(QPointF(x, seen.top()), QPointF(x, seen.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().highlight());
    painter.drawEllipse(QPointF(x, middle), 13, 13);
    painter.setBrush(palette().highlightedText());
    for (const double way : {-1.0, 1.0})
        painter.drawPolygon(QPolygonF(QVector<QPointF>{{x + way * 8.5, middle}, {x + way * 3, middle - 4.5}, {x + way * 3, middle + 4.5}}));
}

/// On a plate, so that it is read on any picture.
void PictureView::drawName(QPainter& painter, int side) {
    const auto seen = target().intersected(rect());
    const double room = (side == 0 ? dividerX() - seen.left() : seen.right() - dividerX()) - 24;
    const QFontMetricsF metrics(font());
    const auto text = metrics.elidedText(names_[static_cast<std::size_t>(side)], Qt::ElideRight, room);
    if (text.size() < 2) return;
    const double width = metrics.horizontalAdvance(text) + 16, height = metrics.height() + 8;
    const QRectF plate(side == 0 ? seen.left() + 8 : seen.right() - 8 - width, seen.top() + 8, width, height);
    auto ground = palette().color(QPalette::Window);
    ground.setAlpha(225);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(plate, 5, 5);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(plate, Qt::AlignCenter, text);
}

void PictureView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (!compares()) {
        drawSide(painter, 0);
        return;
    }
    const auto x = dividerX();
    for (const int side : {0, 1}) {
        painter.save();
        painter.setClipRect(side == 0 ? QRectF(0, 0, x, height()) : QRectF(x, 0, width() - x, height()));
        drawSide(painter, side);
        painter.restore();
    }
    drawDivider(painter);
    for (const int side : {0, 1}) drawName(painter, side);
}

void PictureView::resizeEvent(QResizeEvent*) { fits_ ? fit() : place(); }

void PictureView::wheelEvent(QWheelEvent* event) {
    zoomTo(scale_ * std::pow(1.0015, event->angleDelta().y()), event->position());
    event->accept();
}

void PictureView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    dragged_ = event->localPos();
    drag_ = onDivider(dragged_) ? Drag::Divider : Drag::Pan;
    if (drag_ == Drag::Pan && !fits_) setCursor(Qt::ClosedHandCursor);
}

void PictureView::mouseMoveEvent(QMouseEvent* event) {
    const auto at = event->localPos();
    if (drag_ == Drag::Divider) {
        const auto seen = target().intersected(rect());
        setDivider((at.x() - seen.left()) / std::max(seen.width(), 1.0));
    } else if (drag_ == Drag::Pan && !fits_) {
        corner_ += at - dragged_;
        place();
    } else if (drag_ == Drag::None) {
        setCursor(onDivider(at) ? Qt::SplitHCursor : Qt::CrossCursor);
    }
    dragged_ = at;
    tellHover(at);
}

void PictureView::mouseReleaseEvent(QMouseEvent* event) {
    drag_ = Drag::None;
    setCursor(onDivider(event->localPos()) ? Qt::SplitHCursor : Qt::CrossCursor);
}

void PictureView::mouseDoubleClickEvent(QMouseEvent* event) { fits_ ? zoomTo(1 / devicePixelRatioF(), event->localPos()) : fit(); }

void PictureView::leaveEvent(QEvent*) { emit left(); }

void PictureView::tellHover(QPointF at) {
    const auto area = target();
    if (!area.contains(at)) {
        emit left();
        return;
    }
    const QPointF place((at.x() - area.left()) / area.width(), (at.y() - area.top()) / area.height());
    emit hovered(compares() && at.x() > dividerX() ? 1 : 0, place);
}

}  // namespace luxdeck::gui
