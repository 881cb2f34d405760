#pragma once

#include "analysis/report/canvas.h"
#include "analysis/report/report_contents.h"

#include <QPointF>
#include <QRectF>

#include <algorithm>
#include <vector>

namespace luxdeck::report {

/// The bounds of something flat [m].
struct FlatBounds {
    double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300;

    void add(QPointF p) {
        x0 = std::min(x0, p.x()), x1 = std::max(x1, p.x());
        y0 = std::min(y0, p.y()), y1 = std::max(y1, p.y());
    }
    [[nodiscard]] bool empty() const { return x1 < x0; }
    [[nodiscard]] double width() const { return x1 - x0; }
    [[nodiscard]] double height() const { return y1 - y0; }
    void grow(double metres) { x0 -= metres, y0 -= metres, x1 += metres, y1 += metres; }
};

/// A drawing to scale: metres (x right, y up) to the page's millimetres, centred in `area`.
class PlanScale {
public:
    PlanScale(const FlatBounds& bounds, const QRectF& area);

    [[nodiscard]] QPointF at(QPointF metres) const {
        return {left_ + (metres.x() - x0_) * mmPerMetre_, top_ + (y1_ - metres.y()) * mmPerMetre_};
    }
    [[nodiscard]] double mmPerMetre() const { return mmPerMetre_; }

private:
    double mmPerMetre_ = 1, left_ = 0, top_ = 0, x0_ = 0, y1_ = 0;
};

/// The plane a calculation surface is drawn in: horizontal ones in plan (x right, y up), others as seen from
/// their front with z up.
struct GridPlane {
    Vec3d origin, right, up;
    bool plan = true;

    static GridPlane of(const GridResult& grid);
    [[nodiscard]] QPointF flat(const Vec3d& p) const {
        return {(p - origin).dot(right), (p - origin).dot(up)};
    }
};

/// The corners of the surface that was divided: origin, + u, + u + v, + v; of free points none.
std::vector<Vec3d> surfaceCorners(const GridResult& grid);

FlatBounds boundsOf(const RoomPlan& plan);

struct RoomStyle {
    double wallMm = 0.45;
    bool luminaires = true;
    bool luminaireIds = true;
    double luminaireFill = 0.55;  // opacity
    double luminaireMm = 0.25;    // width of its outline
};

/// Walls, panes, furniture and luminaires.
void drawRoom(Canvas& canvas, const PlanScale& scale, const RoomPlan& plan, const RoomStyle& style);

/// A scale bar of a round length at (x, y), its left end.
void drawScaleBar(Canvas& canvas, const PlanScale& scale, double x, double y);

/// Two arrows named after the axes.
void drawAxes(Canvas& canvas, double x, double y, const QString& right, const QString& up);

/// The whole room small, with the surface in the accent colour.
void drawKeyPlan(Canvas& canvas, const QRectF& area, const RoomPlan& plan, const GridResult& grid);

}  // namespace luxdeck::report
