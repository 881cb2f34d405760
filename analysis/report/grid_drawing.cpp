#include "analysis/report/grid_drawing.h"

#include "analysis/report/number_format.h"
#include "tonemap/isolines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace luxdeck::report {

namespace {

struct LabelBox {
    QPointF centre;
    double width, height;
};

/// Everything the steps of the drawing share.
struct Drawing {
    Canvas& canvas;
    const GridResult& grid;
    GridPlane plane;
    PlanScale scale;
    ValueRange range;
    std::vector<double> values;
    std::vector<LabelBox> labels;  // of the points' values, for isoline labels to keep clear of

    /// Where column x, row y (in units of points, 0 the first) lies on the page.
    [[nodiscard]] QPointF at(double x, double y) const {
        const Vec3d p = grid.origin + grid.u * ((x + 0.5) / grid.columns) + grid.v * ((y + 0.5) / grid.rows);
        return scale.at(plane.flat(p));
    }
};

double lengthOf(QPointF p) { return std::hypot(p.x(), p.y()); }

FlatBounds drawnBounds(const GridResult& grid, const GridPlane& plane, const RoomPlan& plan, const QRectF& area) {
    FlatBounds bounds;
    for (const auto& corner : surfaceCorners(grid)) bounds.add(plane.flat(corner));
    const double size = std::max({bounds.width(), bounds.height(), 0.1});
    bounds.grow(std::max(grid.borderM, 0.0) + 0.04 * size);
    if (!plane.plan) return bounds;
    // The whole room when that does not make the surface much smaller: it is the drawing a reader knows.
    auto room = boundsOf(plan);
    if (room.empty()) return bounds;
    room.add({bounds.x0, bounds.y0});
    room.add({bounds.x1, bounds.y1});
    room.grow(0.01 * size);
    const double alone = PlanScale(bounds, area).mmPerMetre(), within = PlanScale(room, area).mmPerMetre();
    if (within > 0.6 * alone) return room;
    bounds.grow(0.3 * size);  // what stands about it tells where it is
    return bounds;
}

void drawField(Drawing& d) {
    const QPointF corner = d.at(-0.5, -0.5);
    const QPointF u = d.at(d.grid.columns - 0.5, -0.5) - corner, v = d.at(-0.5, d.grid.rows - 0.5) - corner;
    d.canvas.image(corner, u, v, fieldImage(d.values, d.grid.columns, d.grid.rows, d.range), true);
    QPolygonF edge(QVector<QPointF>{corner, corner + u, corner + u + v, corner + v, corner});
    d.canvas.polyline(edge, ink::kBlack, 0.2);
    if (d.grid.borderM <= 0) return;
    const QPointF bu = u / std::max(lengthOf(u), 1e-9) * d.grid.borderM * d.scale.mmPerMetre();
    const QPointF bv = v / std::max(lengthOf(v), 1e-9) * d.grid.borderM * d.scale.mmPerMetre();
    d.canvas.polyline(QPolygonF(QVector<QPointF>{corner - bu - bv, corner + u + bu - bv, corner + u + v + bu + bv, corner + v - bu + bv,
                                 corner - bu - bv}),
                      ink::kGrey, 0.2, Qt::DashLine);
}

/// Smallest k >= 1 so that labels k steps apart do not touch.
int stepFor(QPointF step, const LabelBox& box, int most) {
    int k = 1;
    while (k < most && std::abs(step.x()) * k < box.width && std::abs(step.y()) * k < box.height) ++k;
    return k;
}

/// The room the widest of the values takes, with the gap to its neighbours.
LabelBox widestLabel(const Drawing& d, const TextStyle& style) {
    QString longest;
    for (const double v : d.values)
        if (const auto text = line(formatGridLux(v)); text.size() > longest.size()) longest = text;
    return {{}, d.canvas.textWidth(longest, style) + 1.4, Canvas::lineHeight(style)};
}

TextStyle valueStyle(const Drawing& d, QPointF stepU, QPointF stepV) {
    // As large as the cells allow between 5.6 pt (still read on paper) and 8 pt.
    TextStyle style{8, QFont::Medium, ink::kBlack, Align::Centre};
    while (style.sizePt > 5.6) {
        const auto box = widestLabel(d, style);
        if (stepFor(stepU, box, 2) == 1 && stepFor(stepV, box, 2) == 1) break;
        style.sizePt -= 0.3;
    }
    return style;
}

std::pair<int, int> drawValues(Drawing& d) {
    const QPointF stepU = d.at(1, 0) - d.at(0, 0), stepV = d.at(0, 1) - d.at(0, 0);
    const auto style = valueStyle(d, stepU, stepV);
    auto box = widestLabel(d, style);
    if (stepFor(stepU, box, 2) > 1 || stepFor(stepV, box, 2) > 1) box.width += 2.5, box.height += 1.8;  // when thinning, thin for isolines too
    const int everyU = stepFor(stepU, box, d.grid.columns), everyV = stepFor(stepV, box, d.grid.rows);
    // Start so that what is left over is shared by both ends.
    const int firstU = (d.grid.columns - 1) % everyU / 2, firstV = (d.grid.rows - 1) % everyV / 2;
    for (int j = 0; j < d.grid.rows; ++j)
        for (int i = 0; i < d.grid.columns; ++i) {
            const QPointF at = d.at(i, j);
            const std::size_t index = static_cast<std::size_t>(j) * d.grid.columns + i;
            const bool buried = d.grid.points[index].insideSolid;
            if (i % everyU != firstU || j % everyV != firstV) continue;
            const auto text = line(formatGridLux(d.values[index]));
            const double w = d.canvas.textWidth(text, style) + 0.7, h = Canvas::capHeight(style) + 0.7;
            // A patch of the field's own colour keeps the lines of luminaires and furniture off the digits.
            const double fraction = d.range.fraction(d.values[index]);
            d.canvas.fillRect({at.x() - w / 2, at.y() - h / 2, w, h}, fieldColour(fraction));
            d.canvas.text(at.x(), at.y() + Canvas::capHeight(style) / 2, buried ? "(" + text + ")" : text,
                          style.with(fieldInk(fraction)));
            d.labels.push_back({at, d.canvas.textWidth(text, style), Canvas::capHeight(style)});
        }
    return {everyU, everyV};
}

/// How far a point of an isoline is from the nearest printed value; larger is the better place for its label.
double clearance(const Drawing& d, QPointF at) {
    double nearest = 1e9;
    for (const auto& label : d.labels) {
        const double dx = std::abs(at.x() - label.centre.x()) - label.width / 2 - 2.4;
        const double dy = std::abs(at.y() - label.centre.y()) - label.height / 2 - 1.2;
        nearest = std::min(nearest, std::max(dx, dy));
    }
    return nearest;
}

double lengthOf(const QPolygonF& path) {
    double length = 0;
    for (int i = 1; i < path.size(); ++i) length += lengthOf(path[i] - path[i - 1]);
    return length;
}

void labelIsoline(Drawing& d, const QPolygonF& path, double level) {
    QPointF best = path[path.size() / 2];
    double bestClearance = -1e9;
    for (int i = 1; i < path.size(); ++i) {
        const QPointF at = (path[i - 1] + path[i]) / 2;
        if (const double c = clearance(d, at); c > bestClearance) bestClearance = c, best = at;
    }
    const auto text = line(formatNumber(level));
    const TextStyle style{5.8, QFont::Bold, ink::kAccent, Align::Centre};
    const double width = d.canvas.textWidth(text, style) + 1.2, height = Canvas::capHeight(style) + 1.1;
    d.canvas.fillRect({best.x() - width / 2, best.y() - height / 2, width, height}, ink::kWhite);
    d.canvas.text(best.x(), best.y() + Canvas::capHeight(style) / 2, text, style);
    d.labels.push_back({best, width, height});
}

struct PlacedLine {
    QPolygonF path;
    double level;
};

std::vector<PlacedLine> drawIsolines(Drawing& d) {
    std::vector<PlacedLine> placed;
    if (d.grid.columns < 2 || d.grid.rows < 2) return placed;
    double low = 1e300, high = -1e300;
    for (const double v : d.values)
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    const auto levels = isolineLevels(low, high);
    for (const auto& isoline : tonemap::isolines(d.values, d.grid.columns, d.grid.rows, levels)) {
        QPolygonF path;
        for (const auto& p : isoline.points) path << d.at(p[0], p[1]);
        if (isoline.closed && !path.isEmpty()) path << path.first();
        if (path.size() < 2) continue;
        d.canvas.polyline(path, fieldInk(d.range.fraction(isoline.level)), 0.22);
        placed.push_back({path, isoline.level});
    }
    return placed;
}

/// One label for each level's longest line, where it is long enough to carry one.
void labelIsolines(Drawing& d, const std::vector<PlacedLine>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto longer = [&](const PlacedLine& other) {
            return other.level == lines[i].level && lengthOf(other.path) > lengthOf(lines[i].path);
        };
        if (lengthOf(lines[i].path) < 9 || std::any_of(lines.begin(), lines.end(), longer)) continue;
        labelIsoline(d, lines[i].path, lines[i].level);
    }
}

}  // namespace

GridDrawing drawGrid(Canvas& canvas, const QRectF& area, const RoomPlan& plan, const GridResult& grid,
                     const ValueRange& range) {
    const auto plane = GridPlane::of(grid);
    Drawing d{canvas, grid, plane, PlanScale(drawnBounds(grid, plane, plan, area), area), range, {}, {}};
    for (const auto& point : grid.points) d.values.push_back(knownLux(point.total));
    canvas.clip(area);
    drawField(d);
    const auto lines = drawIsolines(d);
    if (plane.plan) drawRoom(canvas, d.scale, plan, {0.5, true, false, 0.0, 0.15});
    const auto [everyColumn, everyRow] = drawValues(d);
    labelIsolines(d, lines);
    canvas.unclip();
    return {d.scale, everyColumn, everyRow};
}

}  // namespace luxdeck::report
