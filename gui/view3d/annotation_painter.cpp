#include "gui/view3d/annotation_painter.h"

#include "analysis/report/canvas.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <optional>

namespace luxdeck::gui {

namespace {

constexpr int kCell = 96;             // pixels
constexpr double kSymbol = 14;        // of a verdict
constexpr double kGap = 3;            // between numbers

double lightness(const QColor& c) { return 0.2126 * c.redF() + 0.7152 * c.greenF() + 0.0722 * c.blueF(); }

}  // namespace

AnnotationPainter::AnnotationPainter(QPainter& painter, const QRect& area, const ViewColours& colours)
    : painter_(painter), area_(area), colours_(colours), value_(painter.font()), small_(painter.font()), strong_(painter.font()) {
    value_.setPixelSize(12);
    value_.setWeight(QFont::Medium);
    small_.setPixelSize(11);
    strong_.setPixelSize(12);
    strong_.setWeight(QFont::DemiBold);
    columns_ = area.width() / kCell + 1;
    taken_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(area.height() / kCell + 1));
}

bool AnnotationPainter::take(const QRectF& box) {
    if (!area_.intersects(box)) return false;
    const auto cells = [&](const auto& visit) {
        const int x0 = std::max(0, static_cast<int>(box.left()) / kCell), x1 = std::min(columns_ - 1, static_cast<int>(box.right()) / kCell);
        const int rows = static_cast<int>(taken_.size()) / columns_;
        const int y0 = std::max(0, static_cast<int>(box.top()) / kCell), y1 = std::min(rows - 1, static_cast<int>(box.bottom()) / kCell);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x)
                if (!visit(taken_[static_cast<std::size_t>(y * columns_ + x)])) return false;
        return true;
    };
    const bool isFree = cells([&](const std::vector<QRectF>& cell) { return std::none_of(cell.begin(), cell.end(), [&](const QRectF& other) { return other.intersects(box); }); });
    if (!isFree) return false;
    cells([&](std::vector<QRectF>& cell) {
        cell.push_back(box);
        return true;
    });
    return true;
}

bool AnnotationPainter::paint(const Annotation& annotation, QPointF at) {
    using Kind = Annotation::Kind;
    const auto place = [&](const Annotation& text) -> std::optional<QRectF> {
        const QSizeF size = sizeOf(text);
        const QRectF box(at - QPointF(size.width() / 2, size.height() / 2), size);
        if (!take(box.adjusted(-kGap, -1, kGap, 1))) return {};
        return box;
    };
    if (annotation.kind == Kind::Surface) {
        if (const auto box = place(annotation)) return paintSurface(annotation, *box), true;
        Annotation brief = annotation;   // where it is crowded the first figure is what matters
        brief.text = annotation.brief;
        brief.detail.clear();
        if (const auto box = place(brief)) return paintSurface(brief, *box), true;
        return false;
    }
    const auto box = place(annotation);
    if (!box) return false;
    if (annotation.kind == Kind::Value)
        paintNumber(annotation, *box);
    else
        paintPill(annotation, *box);
    return true;
}

QSizeF AnnotationPainter::sizeOf(const Annotation& annotation) const {
    using Kind = Annotation::Kind;
    const QFont& font = annotation.kind == Kind::Surface ? strong_ : annotation.kind == Kind::Value ? value_ : small_;
    const QFontMetricsF metrics(font);
    QSizeF size(metrics.horizontalAdvance(annotation.text), metrics.height());
    if (annotation.kind == Kind::Surface) {
        size.setWidth(std::max(size.width(), QFontMetricsF(small_).horizontalAdvance(annotation.detail)) + (annotation.verdict == Verdict::None ? 0 : kSymbol + 6));
        size.rheight() += annotation.detail.isEmpty() ? 0 : QFontMetricsF(small_).height();
        return size + QSizeF(16, 9);
    }
    if (annotation.kind == Kind::Value) return size;
    size += QSizeF(8, 2);
    size.setWidth(std::max(size.width(), size.height()));
    return size;
}

void AnnotationPainter::paintNumber(const Annotation& annotation, const QRectF& box) {
    const bool bright = annotation.ground.isValid() ? lightness(annotation.ground) > 0.5 : !colours_.dark;
    painter_.setFont(value_);
    painter_.setPen(bright ? QColor(255, 255, 255, 110) : QColor(0, 0, 0, 130));
    painter_.drawText(box.translated(0.7, 0.9), Qt::AlignCenter, annotation.text);
    painter_.setPen(bright ? QColor(16, 18, 22) : QColor(255, 255, 255));
    painter_.drawText(box, Qt::AlignCenter, annotation.text);
}

void AnnotationPainter::paintPill(const Annotation& annotation, const QRectF& box) {
    const bool mark = annotation.kind == Annotation::Kind::Mark;
    QColor paper = annotation.strong ? colours_.accent : mark ? colours_.paper : annotation.ground;
    const QColor ink = annotation.strong ? QColor(Qt::white) : lightness(paper) > 0.5 ? QColor(16, 18, 22) : QColor(255, 255, 255);
    paper.setAlphaF(annotation.strong ? 1 : 0.86);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(paper);
    painter_.drawRoundedRect(box, mark ? box.height() / 2 : 3, mark ? box.height() / 2 : 3);
    painter_.setFont(small_);
    painter_.setPen(ink);
    painter_.drawText(box, Qt::AlignCenter, annotation.text);
}

void AnnotationPainter::paintSurface(const Annotation& annotation, const QRectF& box) {
    QColor paper = colours_.paper;
    paper.setAlphaF(0.92);
    painter_.setPen(annotation.strong ? QPen(colours_.accent, 2) : QPen(QColor(0, 0, 0, 36), 1));
    painter_.setBrush(paper);
    painter_.drawRoundedRect(box, 6, 6);
    QRectF text = box.adjusted(8, 4, -8, -4);
    if (annotation.verdict != Verdict::None) {
        // The report's symbol, in its colours: the same everywhere.
        report::Canvas canvas(painter_, 1, painter_.font().family());
        canvas.verdictSymbol(text.left() + kSymbol / 2, text.center().y(), kSymbol, annotation.verdict);
        text.setLeft(text.left() + kSymbol + 6);
    }
    QColor ink = colours_.ink;
    if (annotation.old) ink.setAlphaF(0.6);
    painter_.setPen(ink);
    painter_.setFont(strong_);
    painter_.drawText(text, Qt::AlignLeft | Qt::AlignTop, annotation.text);
    if (annotation.detail.isEmpty()) return;
    ink.setAlphaF(0.66);
    painter_.setPen(ink);
    painter_.setFont(small_);
    painter_.drawText(text, Qt::AlignLeft | Qt::AlignBottom, annotation.detail);
}

}  // namespace luxdeck::gui
