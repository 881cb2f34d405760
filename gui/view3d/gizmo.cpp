#include "gui/view3d/gizmo.h"

#include <QColor>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace luxdeck::gui {

namespace {

constexpr double kReachPixels = 8;     // from a handle that still takes it
constexpr double kRing = 0.78;         // radius, of the arrows' length
constexpr double kSquareFrom = 0.24, kSquareTo = 0.46;
constexpr int kRingPoints = 48;

Vec3d axisOf(Handle handle) { return handle == Handle::X ? Vec3d(1, 0, 0) : handle == Handle::Y ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1); }

QColor colourOf(Handle handle, const ViewColours& colours) {
    switch (handle) {
        case Handle::X: return {214, 69, 65};
        case Handle::Y: return {60, 150, 62};
        case Handle::Z: return {64, 120, 216};
        default: return colours.accent;
    }
}

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

double distanceToSegment(QPointF p, QPointF a, QPointF b) {
    const QPointF d = b - a;
    const double length2 = QPointF::dotProduct(d, d);
    const double t = length2 > 0 ? std::clamp(QPointF::dotProduct(p - a, d) / length2, 0.0, 1.0) : 0;
    return distance(p, a + d * t);
}

double distanceToPath(QPointF p, const std::vector<QPointF>& path) {
    double nearest = 1e9;
    for (std::size_t i = 1; i < path.size(); ++i) nearest = std::min(nearest, distanceToSegment(p, path[i - 1], path[i]));
    return nearest;
}

}  // namespace

void Gizmo::setTarget(std::optional<Target> target) {
    if (dragging()) return;
    if (target != target_) motion_ = {};
    target_ = target;
    if (!target_) hot_ = Handle::None;
}

std::vector<Handle> Gizmo::handles() const {
    std::vector<Handle> all;
    if (!target_) return all;
    all = {Handle::X, Handle::Y, Handle::Plan};
    if (target_->vertical) all.push_back(Handle::Z);
    if (target_->turns) all.push_back(Handle::Turn);
    return all;
}

std::vector<QPointF> Gizmo::ring() const {
    std::vector<QPointF> points;
    for (int i = 0; i <= kRingPoints; ++i) {
        const double angle = 2 * kPiD * i / kRingPoints;
        if (const auto p = project_(centre() + Vec3d(std::cos(angle), std::sin(angle), 0) * (kRing * sizeM_))) points.push_back(*p);
    }
    return points;
}

std::vector<QPointF> Gizmo::square() const {
    std::vector<QPointF> points;
    for (const auto& [x, y] : std::array<std::array<double, 2>, 4>{{{kSquareFrom, kSquareFrom}, {kSquareTo, kSquareFrom}, {kSquareTo, kSquareTo}, {kSquareFrom, kSquareTo}}})
        if (const auto p = project_(centre() + Vec3d(x, y, 0) * sizeM_)) points.push_back(*p);
    return points;
}

Handle Gizmo::handleAt(QPointF pixel) const {
    Handle best = Handle::None;
    double nearest = kReachPixels;
    for (const auto handle : handles()) {
        double away = 1e9;
        if (handle == Handle::Turn) {
            away = distanceToPath(pixel, ring()) + 1;  // arrows cross it: they go first
        } else if (handle == Handle::Plan) {
            const auto corners = square();
            if (QPolygonF(QVector<QPointF>(corners.begin(), corners.end())).containsPoint(pixel, Qt::OddEvenFill)) away = 0;
        } else {
            const auto from = project_(centre()), to = project_(centre() + axisOf(handle) * sizeM_);
            if (from && to) away = distanceToSegment(pixel, *from, *to);
        }
        if (away < nearest) nearest = away, best = handle;
    }
    return best;
}

std::optional<QPointF> Gizmo::placeOf(Handle handle) const {
    if (!target_ || handle == Handle::None) return {};
    if (handle == Handle::Plan) return project_(centre() + Vec3d(1, 1, 0) * (0.5 * (kSquareFrom + kSquareTo) * sizeM_));
    if (handle == Handle::Turn) return project_(centre() + Vec3d(-1, 1, 0) * (kRing * std::sqrt(0.5) * sizeM_));
    return project_(centre() + axisOf(handle) * (0.9 * sizeM_));
}

bool Gizmo::setHot(Handle handle) {
    if (handle == hot_) return false;
    hot_ = handle;
    return true;
}

void Gizmo::begin(Handle handle, const SightLine& line) {
    held_ = hot_ = handle;
    start_ = line;
    motion_ = {};
}

GizmoMotion Gizmo::drag(const SightLine& line, const Snapping& snapping) {
    if (const auto motion = draggedBy(held_, target_->centre, start_, line, snapping)) motion_ = *motion;
    return motion_;
}

GizmoMotion Gizmo::end() {
    held_ = Handle::None;
    target_->centre += motion_.moveM;  // there it stays until the project says otherwise
    return std::exchange(motion_, {});
}

void Gizmo::paint(QPainter& painter, const ViewColours& colours) const {
    if (!target_) return;
    const auto middle = project_(centre());
    if (!middle) return;
    const auto stands = [&](Handle handle) { return hot_ == handle || held_ == handle; };
    const auto pen = [&](Handle handle, double width) {
        QColor colour = colourOf(handle, colours);
        return QPen(stands(handle) ? colour.lighter(135) : colour, stands(handle) ? width + 1.5 : width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    };
    painter.setBrush(Qt::NoBrush);
    if (target_->turns) {
        const auto points = ring();
        const QPolygonF path(QVector<QPointF>(points.begin(), points.end()));
        painter.setPen(QPen(QColor(255, 255, 255, 150), 5));
        painter.drawPolyline(path);
        painter.setPen(pen(Handle::Turn, 2.2));
        painter.drawPolyline(path);
    }
    for (const auto handle : {Handle::X, Handle::Y, Handle::Z}) {
        if (handle == Handle::Z && !target_->vertical) continue;
        const auto tip = project_(centre() + axisOf(handle) * sizeM_);
        if (!tip || distance(*tip, *middle) < 6) continue;
        painter.setPen(pen(handle, 2.8));
        painter.drawLine(*middle, *tip);
        const QPointF along = (*tip - *middle) / distance(*tip, *middle), across(-along.y(), along.x());
        painter.setBrush(painter.pen().color());
        painter.drawPolygon(QPolygonF(QVector<QPointF>{*tip + along * 9, *tip - along * 3 + across * 5, *tip - along * 3 - across * 5}));
        painter.setBrush(Qt::NoBrush);
    }
    const auto corners = square();
    QColor fill = colours.accent;
    fill.setAlphaF(stands(Handle::Plan) ? 0.8 : 0.45);
    painter.setBrush(fill);
    painter.setPen(pen(Handle::Plan, 1.4));
    painter.drawPolygon(QPolygonF(QVector<QPointF>(corners.begin(), corners.end())));
    painter.setBrush(Qt::white);
    painter.setPen(QPen(colours.ink, 1.5));
    painter.drawEllipse(*middle, 4, 4);
}

}  // namespace luxdeck::gui
