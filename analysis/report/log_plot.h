#pragma once

#include "analysis/report/canvas.h"

namespace luxdeck::report {

/// What a plot is drawn in: the report's inks, or those of a window.
struct PlotInks {
    QColor text = ink::kBlack, quiet = ink::kGrey, hairline = ink::kLight, shade = ink::kPale;
    bool onDark = false;
};

/// Logarithmic axes over a rectangle of the page: seconds to the right, a relative error upwards.
struct LogPlot {
    QRectF area;
    double x0, x1, y0, y1;  // log10 of the ends

    [[nodiscard]] QPointF at(double x, double y) const;
    /// Ends of the axes.
    [[nodiscard]] double left() const;
    [[nodiscard]] double right() const;
    [[nodiscard]] double bottom() const;
    [[nodiscard]] double top() const;
};

/// With round ends (1, 2 or 5 times a power of ten) about the data, all of it above 0.
LogPlot logPlotOf(const QRectF& area, double xLow, double xHigh, double yLow, double yHigh);

/// Axes, hairlines and numbers at 1, 2 and 5 times powers of ten; errors are numbered in %. Titles stand below at the right
/// and above at the left.
void drawLogAxes(Canvas& canvas, const LogPlot& plot, const QString& below, const QString& above, const PlotInks& inks = {});

/// A dashed line of slope -1/2 through a point: the error of independent samples, which halves in four times the time.
void drawHalfSlope(Canvas& canvas, const LogPlot& plot, double seconds, double error, const PlotInks& inks = {});

}  // namespace luxdeck::report
