#pragma once

#include "analysis/photometry/photometric_facts.h"
#include "analysis/report/canvas.h"

namespace luxdeck::report {

/// The polar curve as catalogues print it: C0-C180 solid, C90-C270 dashed, nadir at the bottom. Only the
/// hemisphere that has light is drawn when the other has none. Everything stays inside `area`.
void drawPolar(Canvas& canvas, const QRectF& area, const PolarCurve& curve);

/// Intensity over gamma in the C planes that differ from each other, with lines at 50 % and 10 % of the maximum and a
/// legend below. Only gammas that have light are shown. Everything stays inside `area`.
void drawPlaneCurves(Canvas& canvas, const QRectF& area, const CandelaTable& table);

/// Steps of 1, 2 or 5 times a power of ten from 0 to at least `maximum`, three to six of them.
struct AxisSteps {
    double step = 1;
    int count = 1;
    [[nodiscard]] double top() const { return step * count; }
};
AxisSteps axisSteps(double maximum);

}  // namespace luxdeck::report
