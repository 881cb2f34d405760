#include "gui/panels/page_view.h"

#include <QPainter>
#include <QScrollBar>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {
constexpr double kWidthMm = 210, kHeightMm = 297;
constexpr int kMarginPx = 14;
constexpr double kLeast = 1, kMost = 16;  // widget units for a millimetre
}  // namespace

/// Paper with a shadow.
class PageView::Sheet : public QWidget {
public:
    void setPicture(const QImage& picture) {
        picture_ = picture;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const QRect paper = rect().adjusted(kMarginPx, kMarginPx, -kMarginPx, -kMarginPx);
        painter.fillRect(paper.adjusted(-1, -1, 1, 1), palette().color(QPalette::Mid));
        painter.fillRect(paper, Qt::white);
        if (picture_.isNull()) return;
        const double dots = devicePixelRatioF();
        painter.setRenderHint(QPainter::SmoothPixmapTransform, std::abs(picture_.width() - paper.width() * dots) > 1.5);
        painter.drawImage(paper, picture_);
    }

private:
    QImage picture_;
};

PageView::PageView(QWidget* parent) : QScrollArea(parent), sheet_(new Sheet) {
    setWidget(sheet_);
    setAlignment(Qt::AlignCenter);
    setObjectName(QStringLiteral("pageView"));
    setAccessibleName(tr("Page of the report"));
}

void PageView::setPage(const QImage& picture) { sheet_->setPicture(picture); }

double PageView::dotsPerMm() const { return unitsPerMm_ * devicePixelRatioF(); }

void PageView::fit() {
    fits_ = true;
    const auto room = maximumViewportSize();
    unitsPerMm_ = std::clamp(std::min((room.width() - 2 * kMarginPx) / kWidthMm, (room.height() - 2 * kMarginPx) / kHeightMm), kLeast, kMost);
    place();
}

void PageView::zoomIn() { zoomBy(1.25); }
void PageView::zoomOut() { zoomBy(0.8); }

void PageView::zoomBy(double factor) {
    fits_ = false;
    const auto middleOf = [](const QScrollBar* bar) { return (bar->value() + bar->pageStep() / 2.0) / std::max(1, bar->maximum() + bar->pageStep()); };
    const double across = middleOf(horizontalScrollBar()), down = middleOf(verticalScrollBar());
    unitsPerMm_ = std::clamp(unitsPerMm_ * factor, kLeast, kMost);
    place();
    const auto keep = [](QScrollBar* bar, double middle) { bar->setValue(static_cast<int>(middle * (bar->maximum() + bar->pageStep()) - bar->pageStep() / 2.0)); };
    keep(horizontalScrollBar(), across), keep(verticalScrollBar(), down);
}

void PageView::place() {
    sheet_->resize(static_cast<int>(kWidthMm * unitsPerMm_) + 2 * kMarginPx, static_cast<int>(kHeightMm * unitsPerMm_) + 2 * kMarginPx);
    emit resolutionChanged();
}

void PageView::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    if (fits_) fit();
}

void PageView::wheelEvent(QWheelEvent* event) {
    if (!(event->modifiers() & Qt::ControlModifier)) return QScrollArea::wheelEvent(event);
    zoomBy(std::pow(1.0015, event->angleDelta().y()));
    event->accept();
}

}  // namespace luxdeck::gui
