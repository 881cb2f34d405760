#include "gui/session/scene_pick.h"

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

constexpr int kMostLayers = 64;      // hidden or already picked things that are looked through
constexpr float kStepM = 1e-4F;
constexpr double kBeforeM = 0.02;    // points this far behind what hides them count as lying on it

/// The part of a line that a section leaves.
struct Span {
    double from = 0, to = std::numeric_limits<double>::infinity();
    [[nodiscard]] bool empty() const { return !(from < to); }
};

Span remaining(const CutPlane& section, const Box3& bounds, const SightLine& line) {
    Span span;
    if (!section.on) return span;
    const double slope = line.direction.dot(section.normal);
    const double above = (line.origin - sectionPoint(section, bounds)).dot(section.normal);
    if (std::abs(slope) < 1e-12) return above > 0 ? Span{1, 0} : span;
    const double at = -above / slope;
    if (slope < 0) span.from = std::max(at, 0.0);
    else span.to = at;
    return span;
}

/// Where a ray goes through a calculation surface.
Picked onSurface(const Vec3d& origin, const Vec3d& u, const Vec3d& v, const SightLine& line) {
    Picked picked;
    const Vec3d normal = u.cross(v);
    const double slope = line.direction.dot(normal);
    if (normal.length() < 1e-12 || std::abs(slope) < 1e-12) return picked;
    const double distance = (origin - line.origin).dot(normal) / slope;
    const Vec3d point = line.origin + line.direction * distance, d = point - origin;
    const double a = d.dot(u) / u.dot(u), b = d.dot(v) / v.dot(v);
    if (distance < 0 || a < 0 || a > 1 || b < 0 || b > 1) return picked;
    picked.distanceM = distance;
    picked.point = point;
    picked.normal = normal.normalized() * (slope > 0 ? -1.0 : 1.0);
    return picked;
}

std::vector<Picked> surfacesOn(const Visible& visible, const SightLine& line, const Span& span) {
    std::vector<Picked> found;
    if (!visible.grids) return found;
    const auto& project = visible.project->project;
    const auto add = [&](std::size_t index, const Vec3d& origin, const Vec3d& u, const Vec3d& v) {
        auto picked = onSurface(origin - project.scene.origin, u, v, line);
        if (!picked.any() || picked.distanceM < span.from || picked.distanceM > span.to) return;
        picked.what = {Thing::Grid, index};
        found.push_back(picked);
    };
    if (visible.result != nullptr && visible.result->grids.size() == project.grids.size())
        for (std::size_t i = 0; i < project.grids.size(); ++i) {
            const auto& grid = visible.result->grids[i];
            if (grid.columns > 0 && grid.kind == GridKind::Planar) add(i, grid.origin, grid.u, grid.v);
        }
    else
        for (std::size_t i = 0; i < project.grids.size(); ++i)
            if (project.grids[i].points.empty()) add(i, project.grids[i].origin, project.grids[i].u, project.grids[i].v);
    return found;
}

/// A coloured calculation surface lies before the end of the span.
bool behindSurface(const Visible& visible, const SightLine& line, const Span& span) {
    if (visible.result == nullptr) return false;
    const auto on = surfacesOn(visible, line, span);
    return std::any_of(on.begin(), on.end(), [&](const Picked& p) { return !visible.onlyGrid || *visible.onlyGrid == p.what.index; });
}

bool shown(const Visible& visible, const Hit& hit) {
    if (hit.opening()) return visible.luminaires;
    return visible.surfaces && (visible.hiddenSides >> static_cast<unsigned>(visible.parts->side(hit.mesh, hit.triangle)) & 1U) == 0;
}

Selection thingOf(const Visible& visible, const Hit& hit) {
    if (hit.opening()) return {Thing::Luminaire, hit.luminaire};
    const auto object = visible.project->project.scene.meshes[hit.mesh].object;
    if (const auto luminaire = visible.parts->luminaireOf(object); luminaire && visible.luminaires) return {Thing::Luminaire, *luminaire};
    return {Thing::Object, object};
}

Vec3d normalOf(const Scene& scene, const Hit& hit, const Vec3d& direction) {
    Vec3d normal = -direction;
    if (hit.surface()) {
        const auto& mesh = scene.meshes[hit.mesh];
        const auto& t = mesh.triangles[hit.triangle];
        const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
        normal = (b - a).cross(c - a).normalized();
    }
    return normal.dot(direction) > 0 ? -normal : normal;
}

/// What a line meets, in order, until `enough` says so of one that is shown.
template <class Enough>
void walk(const Visible& visible, const SightLine& line, const Span& span, Targets targets, const Enough& enough) {
    const auto& scene = visible.project->project.scene;
    Ray ray;
    ray.origin = Vec3(line.origin);
    ray.direction = Vec3(line.direction);
    ray.tMin = static_cast<float>(span.from);
    ray.tMax = static_cast<float>(span.to);
    for (int i = 0; i < kMostLayers; ++i) {
        Hit hit;
        visible.project->lit.raycaster().closestHits({&ray, 1}, {&hit, 1}, targets);
        if (!hit.surface() && !hit.opening()) return;
        if (shown(visible, hit)) {
            Picked picked;
            picked.what = thingOf(visible, hit);
            picked.distanceM = double{hit.distance};
            picked.point = line.origin + line.direction * picked.distanceM;
            picked.normal = normalOf(scene, hit, line.direction);
            if (enough(picked)) return;
        }
        ray.tMin = hit.distance + std::max(kStepM, 1e-5F * hit.distance);
    }
}

}  // namespace

Vec3d sectionPoint(const CutPlane& section, const Box3& bounds) {
    const Vec3d middle = bounds.isEmpty() ? Vec3d(0, 0, 0) : Vec3d(bounds.center());
    return middle + section.normal * section.offsetM;
}

double sectionReachM(const Box3& bounds, const Vec3d& normal) {
    if (bounds.isEmpty()) return 1;
    const Vec3d size(bounds.size());
    return 0.5 * (std::abs(normal.x) * size.x + std::abs(normal.y) * size.y + std::abs(normal.z) * size.z);
}

Picked pick(const Visible& visible, const SightLine& line) {
    const auto all = pickAll(visible, line);
    return all.empty() ? Picked{} : all.front();
}

std::vector<Picked> pickAll(const Visible& visible, const SightLine& line) {
    if (visible.project == nullptr) return {};
    const auto span = remaining(visible.section, visible.parts->sceneBounds(), line);
    if (span.empty()) return {};
    auto found = surfacesOn(visible, line, span);
    walk(visible, line, span, Targets::Everything, [&](const Picked& picked) {
        found.push_back(picked);
        return false;
    });
    std::stable_sort(found.begin(), found.end(), [](const Picked& a, const Picked& b) { return a.distanceM < b.distanceM; });
    std::vector<Picked> once;
    for (const auto& picked : found)
        if (std::none_of(once.begin(), once.end(), [&](const Picked& p) { return p.what == picked.what; })) once.push_back(picked);
    return once;
}

void seePoints(const Visible& visible, const CameraPose& pose, const std::vector<Vec3d>& points, std::vector<std::uint8_t>& seen) {
    seen.assign(points.size(), 1);
    if (visible.project == nullptr || !visible.surfaces) return;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3d from = pose.parallel ? points[i] - pose.direction * depthOf(pose, points[i]) : pose.position;
        const double distance = (points[i] - from).length();
        if (distance <= kBeforeM) continue;
        const SightLine line{from, (points[i] - from) / distance};
        auto span = remaining(visible.section, visible.parts->sceneBounds(), line);
        if (span.from > distance || span.to < distance) {
            seen[i] = 0;
            continue;
        }
        span.to = distance - kBeforeM;
        if (span.empty()) continue;
        if (behindSurface(visible, line, span)) {
            seen[i] = 0;
            continue;
        }
        walk(visible, line, span, Targets::Opaque, [&](const Picked&) {
            seen[i] = 0;
            return true;
        });
    }
}

}  // namespace luxdeck::gui
