#include "analysis/report/plan_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

namespace luxdeck {

namespace {

constexpr double kGridM = 1e-4;  // pieces closer than this are one: a tenth of a millimetre is below any drawing

/// A straight line of the plan: kind, direction and distance from the origin, rounded so that collinear
/// pieces share it.
using LineKey = std::tuple<int, long, long>;

struct Span {
    double from, to;
};

struct LineSpans {
    double angle = 0;     // of the line's direction [rad], in (-pi/2, pi/2]
    double distance = 0;  // of the line from the reference point, along its normal [m]
    std::vector<Span> spans;
};

using Lines = std::map<LineKey, LineSpans>;

/// Adds a segment, given relative to the reference point, to the line it lies on.
void addSegment(Lines& lines, PlanLine kind, Vec3d a, Vec3d b) {
    if ((a.x > b.x) || (a.x == b.x && a.y > b.y)) std::swap(a, b);
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double length = std::hypot(dx, dy);
    if (length < kGridM) return;
    double angle = std::atan2(dy, dx);
    if (angle < -kPiD / 2 + 1e-4) angle += kPiD;  // straight up and straight down are one direction
    const double c = std::cos(angle), s = std::sin(angle);
    const double distance = -s * a.x + c * a.y;
    // 1e-3 rad and a millimetre: pieces of one wall differ by rounding alone, other walls by far more
    const LineKey key{static_cast<int>(kind), std::lround(angle * 1e3), std::lround(distance * 1e3)};
    auto& line = lines[key];
    if (line.spans.empty()) line.angle = angle, line.distance = distance;
    const double ta = c * a.x + s * a.y, tb = c * b.x + s * b.y;
    line.spans.push_back({std::min(ta, tb), std::max(ta, tb)});
}

/// Where the plane z = height meets a triangle, if it crosses it.
std::optional<std::array<Vec3d, 2>> cutTriangle(const std::array<Vec3d, 3>& p, double height) {
    std::array<Vec3d, 2> ends;
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3 && found < 2; ++i) {
        const Vec3d &a = p[i], &b = p[(i + 1) % 3];
        if ((a.z < height) == (b.z < height)) continue;
        ends[found++] = a + (b - a) * ((height - a.z) / (b.z - a.z));
    }
    if (found < 2) return std::nullopt;
    return ends;
}

std::size_t cutMesh(Lines& lines, const Mesh& mesh, PlanLine kind, double height) {
    std::size_t pieces = 0;
    for (const auto& t : mesh.triangles) {
        const auto cut = cutTriangle({Vec3d(mesh.positions[t[0]]), Vec3d(mesh.positions[t[1]]), Vec3d(mesh.positions[t[2]])}, height);
        if (!cut) continue;
        addSegment(lines, kind, (*cut)[0], (*cut)[1]);
        ++pieces;
    }
    return pieces;
}

struct ZRange {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

std::vector<ZRange> objectHeights(const Scene& scene) {
    std::vector<ZRange> ranges(scene.objects.size());
    for (const auto& mesh : scene.meshes) {
        if (mesh.object >= ranges.size()) continue;
        auto& range = ranges[mesh.object];
        for (const auto& p : mesh.positions) {
            range.low = std::min<double>(range.low, p.z);
            range.high = std::max<double>(range.high, p.z);
        }
    }
    return ranges;
}

/// Furniture below the cut: its outline a centimetre under its top (the edge of a table), or half-way up
/// where the top is a sheet without thickness.
void cutFurniture(Lines& lines, const Mesh& mesh, const ZRange& range) {
    if (cutMesh(lines, mesh, PlanLine::Furniture, range.high - 0.01) == 0)
        cutMesh(lines, mesh, PlanLine::Furniture, 0.5 * (range.low + range.high));
}

std::vector<PlanSegment> joined(Lines& lines, const Vec3d& origin) {
    std::vector<PlanSegment> out;
    for (auto& [key, line] : lines) {
        std::sort(line.spans.begin(), line.spans.end(), [](const Span& a, const Span& b) {
            return std::tie(a.from, a.to) < std::tie(b.from, b.to);
        });
        const double c = std::cos(line.angle), s = std::sin(line.angle);
        const auto emit = [&](const Span& span) {
            const auto x = [&](double t) { return origin.x + c * t - s * line.distance; };
            const auto y = [&](double t) { return origin.y + s * t + c * line.distance; };
            out.push_back({static_cast<PlanLine>(std::get<0>(key)), x(span.from), y(span.from), x(span.to), y(span.to)});
        };
        Span open = line.spans.front();
        for (const auto& span : line.spans) {
            if (span.from > open.to + kGridM) {
                emit(open);
                open = span;
            }
            open.to = std::max(open.to, span.to);
        }
        emit(open);
    }
    return out;
}

}  // namespace

std::vector<PlanSegment> planSection(const Scene& scene, double heightM) {
    const double height = heightM - scene.origin.z;
    const auto heights = objectHeights(scene);
    Lines lines;
    for (const auto& mesh : scene.meshes) {
        const bool known = mesh.object < scene.objects.size();
        const bool movable = known && scene.objects[mesh.object].movable;
        const bool glass = mesh.material < scene.materials.size() &&
                           scene.materials[mesh.material].kind == MaterialKind::ThinGlass;
        if (movable && heights[mesh.object].high < height)
            cutFurniture(lines, mesh, heights[mesh.object]);
        else
            cutMesh(lines, mesh, movable ? PlanLine::Furniture : glass ? PlanLine::Glass : PlanLine::Solid, height);
    }
    return joined(lines, scene.origin);
}

RoomPlan roomPlan(const Scene& scene, double heightM) {
    RoomPlan plan;
    plan.cutHeightM = heightM;
    plan.segments = planSection(scene, heightM);
    for (const auto& luminaire : scene.luminaires) {
        if (luminaire.type >= scene.luminaireTypes.size()) continue;
        const auto& type = scene.luminaireTypes[luminaire.type];
        const auto& opening = type.photometry.opening;
        const Vec3& x = luminaire.frame.tangent;
        plan.luminaires.push_back({type.id, scene.toUser(luminaire.position), opening.lengthM, opening.widthM,
                                   std::atan2(x.y, x.x),
                                   opening.shape == OpeningShape::Disc || opening.shape == OpeningShape::Cylinder ||
                                       opening.shape == OpeningShape::Sphere});
    }
    return plan;
}

}  // namespace luxdeck
