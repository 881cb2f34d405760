#pragma once

#include "analysis/report/canvas.h"
#include "analysis/report/plan_drawing.h"
#include "analysis/report/value_field.h"

namespace luxdeck::report {

/// What the drawing of a surface left out, for its caption.
struct GridDrawing {
    PlanScale scale;
    int everyColumn = 1;  // values are printed for every n-th column and row
    int everyRow = 1;
};

/// Draws a surface into `area`: colours, isolines with labels, the room about it (in plan), the points' values.
/// The grid has columns and rows.
GridDrawing drawGrid(Canvas& canvas, const QRectF& area, const RoomPlan& plan, const GridResult& grid,
                     const ValueRange& range);

}  // namespace luxdeck::report
