#include "analysis/report/plan_drawing.h"

#include "analysis/report/number_format.h"

#include <algorithm>
#include <cmath>

namespace luxdeck::report {

PlanScale::PlanScale(const FlatBounds& bounds, const QRectF& area) {
    const double width = bounds.empty() ? 1 : std::max(bounds.width(), 1e-3);
    const double height = bounds.empty() ? 1 : std::max(bounds.height(), 1e-3);
    x0_ = bounds.empty() ? 0 : bounds.x0;
    y1_ = bounds.empty() ? 1 : bounds.y1;
    mmPerMetre_ = std::min(area.width() / width, area.height() / height);
    left_ = area.x() + (area.width() - width * mmPerMetre_) / 2;
    top_ = area.y() + (area.height() - height * mmPerMetre_) / 2;
}

GridPlane GridPlane::of(const GridResult& grid) {
    Vec3d normal = grid.u.cross(grid.v);
    if (normal.length() < 1e-12) normal = grid.points.empty() ? Vec3d(0, 0, 1) : grid.points.front().normal;
    if (normal.length() < 1e-12) normal = Vec3d(0, 0, 1);
    normal.normalize();
    if (std::abs(normal.z) > 0.985) return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, true};  // within 10 degrees of level
    const Vec3d up = (Vec3d(0, 0, 1) - normal * normal.z).normalized();
    return {grid.origin, up.cross(normal), up, false};
}

std::vector<Vec3d> surfaceCorners(const GridResult& grid) {
    if (grid.columns <= 0 || grid.rows <= 0) return {};
    return {grid.origin, grid.origin + grid.u, grid.origin + grid.u + grid.v, grid.origin + grid.v};
}

FlatBounds boundsOf(const RoomPlan& plan) {
    FlatBounds bounds;
    for (const auto& s : plan.segments) {
        bounds.add({s.x0, s.y0});
        bounds.add({s.x1, s.y1});
    }
    if (plan.segments.empty())
        for (const auto& l : plan.luminaires) bounds.add({l.position.x, l.position.y});
    return bounds;
}

namespace {

void drawLuminaire(Canvas& canvas, const PlanScale& scale, const PlanLuminaire& luminaire, const RoomStyle& style) {
    const QPointF centre = scale.at({luminaire.position.x, luminaire.position.y});
    // At least 1.2 mm on paper, or a spot would vanish.
    const double least = 1.2 / scale.mmPerMetre();
    const double a = std::max(luminaire.lengthM, least) / 2;
    const double b = std::max(luminaire.widthM, luminaire.round ? luminaire.lengthM : least) / 2;
    auto tint = ink::kWhite;
    tint.setAlphaF(style.luminaireFill);
    if (luminaire.round || luminaire.lengthM <= 0) {
        canvas.disc(centre.x(), centre.y(), a * scale.mmPerMetre(), tint);
        canvas.ring(centre.x(), centre.y(), a * scale.mmPerMetre(), ink::kAccent, style.luminaireMm);
    } else {
        const double c = std::cos(luminaire.angle), s = std::sin(luminaire.angle);
        QPolygonF box;
        for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}})
            box << scale.at({luminaire.position.x + i * a * c - j * std::max(b, least / 2) * s,
                             luminaire.position.y + i * a * s + j * std::max(b, least / 2) * c});
        canvas.fill(box, tint);
        canvas.polyline(box, ink::kAccent, style.luminaireMm);
    }
    if (style.luminaireIds) canvas.text(centre.x() + 1.1, centre.y() - 1.7, line(luminaire.id), {5.5, QFont::DemiBold, ink::kAccent});
}

}  // namespace

void drawRoom(Canvas& canvas, const PlanScale& scale, const RoomPlan& plan, const RoomStyle& style) {
    for (const auto& s : plan.segments) {
        const QPointF a = scale.at({s.x0, s.y0}), b = scale.at({s.x1, s.y1});
        if (s.line == PlanLine::Solid) canvas.stroke(a.x(), a.y(), b.x(), b.y(), ink::kBlack, style.wallMm);
        if (s.line == PlanLine::Glass) canvas.stroke(a.x(), a.y(), b.x(), b.y(), ink::kAccent, style.wallMm * 0.5);
        if (s.line == PlanLine::Furniture) canvas.stroke(a.x(), a.y(), b.x(), b.y(), ink::kGrey, style.wallMm * 0.35);
    }
    if (!style.luminaires) return;
    for (const auto& luminaire : plan.luminaires) drawLuminaire(canvas, scale, luminaire, style);
}

void drawScaleBar(Canvas& canvas, const PlanScale& scale, double x, double y) {
    const double wanted = 30 / scale.mmPerMetre();  // about 30 mm long
    double length = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double step : {5.0, 2.0})
        if (length * step <= wanted) {
            length *= step;
            break;
        }
    const double mm = length * scale.mmPerMetre();
    canvas.fillRect({x, y - 0.9, mm / 2, 0.9}, ink::kBlack);
    canvas.outlineRect({x, y - 0.9, mm, 0.9}, ink::kBlack, 0.2);
    const TextStyle label{6.5, QFont::Normal, ink::kGrey};
    canvas.text(x, y + 3, "0", label);
    canvas.text(x + mm, y + 3, line(formatNumber(length) + " m"), label.aligned(Align::Centre));
}

void drawAxes(Canvas& canvas, double x, double y, const QString& right, const QString& up) {
    const double length = 6;
    const TextStyle label{6.5, QFont::Medium, ink::kGrey};
    canvas.stroke(x, y, x + length, y, ink::kBlack, 0.25);
    canvas.stroke(x, y, x, y - length, ink::kBlack, 0.25);
    canvas.fill(QPolygonF(QVector<QPointF>{{x + length + 1.2, y}, {x + length - 0.3, y - 0.6}, {x + length - 0.3, y + 0.6}}), ink::kBlack);
    canvas.fill(QPolygonF(QVector<QPointF>{{x, y - length - 1.2}, {x - 0.6, y - length + 0.3}, {x + 0.6, y - length + 0.3}}), ink::kBlack);
    canvas.text(x + length + 2, y + 0.8, right, label);
    canvas.text(x + 1.4, y - length + 0.6, up, label);
}

void drawKeyPlan(Canvas& canvas, const QRectF& area, const RoomPlan& plan, const GridResult& grid) {
    auto bounds = boundsOf(plan);
    const auto corners = surfaceCorners(grid);
    for (const auto& c : corners) bounds.add({c.x, c.y});
    for (const auto& p : grid.points) bounds.add({p.position.x, p.position.y});
    if (bounds.empty()) return;
    bounds.grow(0.02 * std::max(bounds.width(), bounds.height()) + 1e-3);
    auto drawn = area;
    drawn.setHeight(std::min(area.height(), area.width() * bounds.height() / bounds.width()));
    const PlanScale scale(bounds, drawn);
    QPolygonF surface;
    for (const auto& c : corners) surface << scale.at({c.x, c.y});
    if (!surface.isEmpty()) {
        surface << surface.first();
        auto tint = ink::kAccent;
        tint.setAlphaF(0.25);
        canvas.fill(surface, tint);
    }
    drawRoom(canvas, scale, plan, {0.3, false, false});
    if (!surface.isEmpty()) {
        canvas.polyline(surface, ink::kAccent, GridPlane::of(grid).plan ? 0.4 : 1.1);
    } else {
        for (const auto& p : grid.points) {
            const auto at = scale.at({p.position.x, p.position.y});
            canvas.disc(at.x(), at.y(), 0.6, ink::kAccent);
        }
    }
}

}  // namespace luxdeck::report
