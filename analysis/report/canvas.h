#pragma once

#include "analysis/grids/solve_result.h"

#include <QColor>
#include <QFont>
#include <QImage>
#include <QPainter>
#include <QPolygonF>
#include <QStringList>

#include <string>
#include <string_view>
#include <vector>

namespace luxdeck::report {

/// The report's colours: black, greys and one accent; green, red and amber speak of verdicts alone.
namespace ink {
inline const QColor kBlack{20, 22, 26};
inline const QColor kGrey{105, 110, 118};
inline const QColor kLight{214, 217, 221};
inline const QColor kPale{243, 244, 246};
inline const QColor kWhite{255, 255, 255};
inline const QColor kAccent{35, 64, 200};
inline const QColor kMet{18, 128, 72};
inline const QColor kNotMet{200, 32, 44};
inline const QColor kUndecided{196, 122, 0};
}  // namespace ink

enum class Align { Left, Centre, Right };

struct TextStyle {
    double sizePt = 8.5;
    QFont::Weight weight = QFont::Normal;
    QColor colour = ink::kBlack;
    Align align = Align::Left;
    double turnDeg = 0;  // counter-clockwise

    [[nodiscard]] TextStyle with(QColor c) const { auto s = *this; s.colour = c; return s; }
    [[nodiscard]] TextStyle aligned(Align a) const { auto s = *this; s.align = a; return s; }
};

/// The styles of the report's text: one family, few sizes.
namespace type {
inline const TextStyle kDisplay{32, QFont::Bold};
inline const TextStyle kTitle{20, QFont::Bold};
inline const TextStyle kHeading{10.5, QFont::DemiBold};
inline const TextStyle kBody{8.5, QFont::Normal};
inline const TextStyle kStrong{8.5, QFont::DemiBold};
inline const TextStyle kLabel{7, QFont::Medium, ink::kGrey};
inline const TextStyle kSmall{7, QFont::Normal, ink::kGrey};
}  // namespace type

/// Text as one line: control characters and line ends become single spaces.
QString line(std::string_view text);

/// The first installed family of those the report is designed with; empty when no font is installed at all.
QString reportFontFamily();

/// A page to draw on, in millimetres from its top left corner; text stands on its baseline.
/// Owns nothing; lives as long as the painter. One thread.
class Canvas {
public:
    Canvas(QPainter& painter, double dotsPerMm, QString family);

    [[nodiscard]] double textWidth(const QString& text, const TextStyle& style) const;
    /// From one baseline to the next.
    [[nodiscard]] static double lineHeight(const TextStyle& style) { return style.sizePt * 1.36 * 25.4 / 72; }
    /// Height of a digit above the baseline, for centring.
    [[nodiscard]] static double capHeight(const TextStyle& style) { return style.sizePt * 0.727 * 25.4 / 72; }
    /// Lines of at most `widthMm`; breaks between words, and inside words that alone are too wide.
    [[nodiscard]] QStringList wrap(const QString& text, double widthMm, const TextStyle& style) const;
    [[nodiscard]] QString elided(const QString& text, double widthMm, const TextStyle& style) const;

    void text(double x, double y, const QString& text, const TextStyle& style);
    /// Wrapped text whose first line's top is at `y`; returns the height it took.
    double paragraph(double x, double y, double widthMm, const QString& text, const TextStyle& style);

    void stroke(double x0, double y0, double x1, double y1, QColor colour, double widthMm,
                Qt::PenStyle pen = Qt::SolidLine);
    void polyline(const QPolygonF& points, QColor colour, double widthMm, Qt::PenStyle pen = Qt::SolidLine);
    void fill(const QPolygonF& points, QColor colour);
    void fillRect(const QRectF& rect, QColor colour);
    void outlineRect(const QRectF& rect, QColor colour, double widthMm);
    void disc(double x, double y, double radius, QColor colour);
    void ring(double x, double y, double radius, QColor colour, double widthMm);
    void image(const QRectF& rect, const QImage& picture);
    /// A picture on the parallelogram that `corner`, `corner + across` (its top edge), `corner + down` span.
    void image(QPointF corner, QPointF across, QPointF down, const QImage& picture, bool smooth);

    /// Draws inside `rect` alone until unclip().
    void clip(const QRectF& rect);
    void unclip();

    /// A verdict as a coloured symbol of height `size`, its centre at (x, y): tick, cross or question mark.
    void verdictSymbol(double x, double y, double size, Verdict verdict);

private:
    [[nodiscard]] QFont font(const TextStyle& style, const QString& text) const;
    [[nodiscard]] QPointF dots(double x, double y) const { return {x * dots_, y * dots_}; }
    [[nodiscard]] QPolygonF dots(const QPolygonF& points) const;
    [[nodiscard]] QRectF dots(const QRectF& r) const {
        return {r.x() * dots_, r.y() * dots_, r.width() * dots_, r.height() * dots_};
    }
    [[nodiscard]] QPen pen(QColor colour, double widthMm, Qt::PenStyle style) const;

    QPainter& painter_;
    double dots_;      // a millimetre
    QString family_;
};

QColor verdictColour(Verdict verdict);

}  // namespace luxdeck::report
