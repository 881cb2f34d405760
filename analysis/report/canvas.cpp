#include "analysis/report/canvas.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QFontMetricsF>
#include <QTextLayout>

#include <algorithm>

namespace luxdeck::report {

QString line(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<int>(text.size())).simplified();
}

QString reportFontFamily() {
    const auto families = QFontDatabase().families();
    for (const char* wanted : {"Inter", "DejaVu Sans", "Noto Sans", "Liberation Sans", "FreeSans"})
        if (families.contains(wanted)) return wanted;
    // fontconfig's aliases ("Serif") are listed even when nothing stands behind them.
    return families.isEmpty() ? QString() : QFontInfo(QFont(families.front())).family();
}

QColor verdictColour(Verdict verdict) {
    switch (verdict) {
        case Verdict::Met: return ink::kMet;
        case Verdict::NotMet: return ink::kNotMet;
        case Verdict::Undecided: return ink::kUndecided;
        case Verdict::None: break;
    }
    return ink::kGrey;
}

Canvas::Canvas(QPainter& painter, double dotsPerMm, QString family)
    : painter_(painter), dots_(dotsPerMm), family_(std::move(family)) {
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setRenderHint(QPainter::SmoothPixmapTransform);
}

namespace {

/// Kerning and other shaping are for words alone. Inter's contextual forms of signs beside digits (a raised
/// minus in 1−2, a cross in 3x4) have no character of their own: searching the PDF would not find them.
bool wordsAlone(const QString& text) {
    return std::all_of(text.begin(), text.end(), [](QChar c) { return c.isLetter() || c == ' ' || c == ',' || c == '.'; });
}

}  // namespace

QFont Canvas::font(const TextStyle& style, const QString& text) const {
    QFont font(family_);
    if (!wordsAlone(text)) font.setStyleStrategy(QFont::PreferNoShaping);
    font.setPixelSize(std::max(1, static_cast<int>(style.sizePt * dots_ * 25.4 / 72 + 0.5)));
    font.setWeight(style.weight);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

QPen Canvas::pen(QColor colour, double widthMm, Qt::PenStyle style) const {
    QPen pen(colour, widthMm * dots_, style, Qt::FlatCap, Qt::RoundJoin);
    return pen;
}

QPolygonF Canvas::dots(const QPolygonF& points) const {
    QPolygonF scaled;
    scaled.reserve(points.size());
    for (const auto& p : points) scaled << p * dots_;
    return scaled;
}

double Canvas::textWidth(const QString& text, const TextStyle& style) const {
    return QFontMetricsF(font(style, text)).horizontalAdvance(text) / dots_;
}

QStringList Canvas::wrap(const QString& text, double widthMm, const TextStyle& style) const {
    QTextLayout layout(text, font(style, text));
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    QStringList lines;
    layout.beginLayout();
    for (auto row = layout.createLine(); row.isValid(); row = layout.createLine()) {
        row.setLineWidth(widthMm * dots_);
        lines << text.mid(row.textStart(), row.textLength()).trimmed();
    }
    layout.endLayout();
    return lines.isEmpty() ? QStringList{QString()} : lines;
}

QString Canvas::elided(const QString& text, double widthMm, const TextStyle& style) const {
    return QFontMetricsF(font(style, text)).elidedText(text, Qt::ElideRight, widthMm * dots_);
}

void Canvas::text(double x, double y, const QString& text, const TextStyle& style) {
    if (text.isEmpty()) return;
    painter_.save();
    painter_.translate(dots(x, y));
    if (style.turnDeg != 0) painter_.rotate(-style.turnDeg);
    painter_.setFont(font(style, text));
    painter_.setPen(style.colour);
    const double width = style.align == Align::Left ? 0 : textWidth(text, style) * dots_;
    const double shift = style.align == Align::Right ? width : width / 2;
    painter_.drawText(QPointF(-shift, 0), text);
    painter_.restore();
}

double Canvas::paragraph(double x, double y, double widthMm, const QString& words, const TextStyle& style) {
    const auto lines = wrap(words, widthMm, style);
    const double anchor = style.align == Align::Left ? x : style.align == Align::Right ? x + widthMm : x + widthMm / 2;
    double baseline = y + capHeight(style) * 1.25;
    for (const auto& row : lines) {
        text(anchor, baseline, row, style);
        baseline += lineHeight(style);
    }
    return lineHeight(style) * lines.size();
}

void Canvas::stroke(double x0, double y0, double x1, double y1, QColor colour, double widthMm, Qt::PenStyle style) {
    painter_.setPen(pen(colour, widthMm, style));
    painter_.drawLine(dots(x0, y0), dots(x1, y1));
}

void Canvas::polyline(const QPolygonF& points, QColor colour, double widthMm, Qt::PenStyle style) {
    painter_.setPen(pen(colour, widthMm, style));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPolyline(dots(points));
}

void Canvas::fill(const QPolygonF& points, QColor colour) {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colour);
    painter_.drawPolygon(dots(points));
}

void Canvas::fillRect(const QRectF& rect, QColor colour) { painter_.fillRect(dots(rect), colour); }

void Canvas::outlineRect(const QRectF& rect, QColor colour, double widthMm) {
    painter_.setPen(pen(colour, widthMm, Qt::SolidLine));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(dots(rect));
}

void Canvas::disc(double x, double y, double radius, QColor colour) {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colour);
    painter_.drawEllipse(dots(x, y), radius * dots_, radius * dots_);
}

void Canvas::ring(double x, double y, double radius, QColor colour, double widthMm) {
    painter_.setPen(pen(colour, widthMm, Qt::SolidLine));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawEllipse(dots(x, y), radius * dots_, radius * dots_);
}

void Canvas::image(const QRectF& rect, const QImage& picture) { painter_.drawImage(dots(rect), picture); }

void Canvas::image(QPointF corner, QPointF across, QPointF down, const QImage& picture, bool smooth) {
    if (picture.isNull()) return;
    const double w = picture.width(), h = picture.height();
    painter_.save();
    painter_.setRenderHint(QPainter::SmoothPixmapTransform, smooth);
    painter_.setRenderHint(QPainter::LosslessImageRendering);  // no JPEG rings in a colour scale
    painter_.setTransform(QTransform(across.x() * dots_ / w, across.y() * dots_ / w, down.x() * dots_ / h,
                                     down.y() * dots_ / h, corner.x() * dots_, corner.y() * dots_), true);
    painter_.drawImage(QPointF(0, 0), picture);
    painter_.restore();
}

void Canvas::clip(const QRectF& rect) {
    painter_.save();
    painter_.setClipRect(dots(rect));
}

void Canvas::unclip() { painter_.restore(); }

void Canvas::verdictSymbol(double x, double y, double size, Verdict verdict) {
    const double r = size / 2;
    if (verdict == Verdict::None) return;
    disc(x, y, r, verdictColour(verdict));
    const double w = size * 0.13;
    if (verdict == Verdict::Met) {
        polyline(QPolygonF(QVector<QPointF>{{x - 0.48 * r, y + 0.05 * r}, {x - 0.12 * r, y + 0.4 * r}, {x + 0.5 * r, y - 0.36 * r}}),
                 ink::kWhite, w);
    } else if (verdict == Verdict::NotMet) {
        const double d = 0.4 * r;
        stroke(x - d, y - d, x + d, y + d, ink::kWhite, w);
        stroke(x - d, y + d, x + d, y - d, ink::kWhite, w);
    } else {
        TextStyle mark{size * 0.72 * 72 / 25.4, QFont::Bold, ink::kWhite, Align::Centre};
        text(x, y + capHeight(mark) / 2, "?", mark);
    }
}

}  // namespace luxdeck::report
