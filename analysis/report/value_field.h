#pragma once

#include "analysis/report/canvas.h"
#include "analysis/report/plan_drawing.h"

#include <QImage>

#include <vector>

namespace luxdeck::report {

/// The range a colour scale covers, with round ends.
struct ValueRange {
    double low = 0, high = 1;

    [[nodiscard]] double fraction(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

/// A range with round ends about the finite ones of the values; one unit wide at least, so that equal values work.
ValueRange roundRange(const std::vector<double>& values);

/// Levels for isolines inside the range, from the lighting profession's series (... 100 150 200 300 500 750
/// 1000 ...), or evenly spaced round ones where the series would give fewer than three.
std::vector<double> isolineLevels(double low, double high);

/// The colour of a fraction 0..1 of a scale, a little paler than on screens: paper is darker.
QColor fieldColour(double fraction);

/// Black or white, whichever reads better on fieldColour(fraction).
QColor fieldInk(double fraction);

/// A grid's values as smooth colours: columns along x, rows downwards from the first; values lie at the
/// centres of cells and are interpolated bilinearly between them, constant outside the outer ones.
QImage fieldImage(const std::vector<double>& values, int columns, int rows, const ValueRange& range);

/// A bar of the scale's colours with its unit and round ticks; its bar's top left is (x, y).
void drawColourBar(Canvas& canvas, double x, double y, double widthMm, const ValueRange& range, const QString& unit);

}  // namespace luxdeck::report
