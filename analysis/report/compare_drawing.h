#pragma once

#include "analysis/compare/comparison.h"
#include "analysis/report/canvas.h"
#include "analysis/report/log_plot.h"

#include <vector>

namespace luxdeck::report {

/// The colour that an algorithm has in every plot of a comparison: told apart with all kinds of colour blindness.
QColor colourOf(const Comparison& comparison, const std::string& algorithm, const PlotInks& inks = {});

/// Error against run time of every algorithm, each named where its curve ends, with slope and bias beneath. Bars are 95 %
/// intervals; arrows point down from bounds; the shaded part is below what the reference can tell.
void drawErrorCurves(Canvas& canvas, const QRectF& area, const Comparison& comparison, const ComparedReference& reference, const PlotInks& inks = {});

/// A run where drawErrorCurves() draws it on the same area; of a bound, the bound.
struct PlottedRun {
    const ComparedRun* run = nullptr;
    QPointF at;
};
std::vector<PlottedRun> plottedRuns(const QRectF& area, const Comparison& comparison, const ComparedReference& reference);

/// Where the errors are: for every algorithm a plan of the room with the grids' points, coloured by their errors at the largest
/// budget, and the scale of the colours below. Nothing when no grid was compared.
void drawErrorPlans(Canvas& canvas, QPointF at, double widthMm, const Comparison& comparison);
/// The height that these take; 0 when there is nothing to draw.
double errorPlansHeightMm(const Comparison& comparison, double widthMm);

/// "−0.50 ± 0.03"; a dash where its interval is not known.
QString slopeText(const ComparedSlope& slope);

/// "112 points; reference by shared, known to ± 1 %".
QString referenceText(const ComparedReference& reference);

}  // namespace luxdeck::report
