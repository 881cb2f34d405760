#include "engine/io/rad_surface.h"

#include "engine/io/obj_polygon.h"
#include "engine/io/rad_polygon.h"
#include "engine/io/rad_transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck::rad {

namespace {

using Index = std::uint32_t;

std::vector<Vec3d> cornersOf(const Primitive& p) {
    std::vector<Vec3d> corners;
    for (std::size_t i = 0; i + 2 < p.numbers.size(); i += 3) corners.emplace_back(p.numbers[i], p.numbers[i + 1], p.numbers[i + 2]);
    return corners;
}

double triangleArea(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return 0.5 * (b - a).cross(c - a).length(); }

/// Chords that a circle of this radius is cut into; even.
int segmentsOf(double radius, const Fineness& fineness) {
    const double r = radius * fineness.metresPerUnit;
    const double tolerance = std::min(r / 200, 0.5e-3) / (fineness.fine ? 10 : 1);
    const double least = fineness.fine ? 64 : 16, most = fineness.fine ? 1024 : 512;
    const double chords = r > 0 ? kPiD / std::acos(std::max(0.0, 1 - tolerance / r)) : least;
    return 2 * static_cast<int>(std::ceil(std::clamp(chords, least, most) / 2));
}

/// Two directions that make a right-handed frame with a unit axis.
std::pair<Vec3d, Vec3d> across(const Vec3d& axis) {
    const Vec3d helper = std::abs(axis.z) < 0.9 ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0);
    const Vec3d u = helper.cross(axis).normalized();
    return {u, axis.cross(u)};
}

void turnInwards(SurfaceMesh& mesh) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    for (auto& n : mesh.normals) n = -n;
}

Error wrongSize(const Primitive& p, const char* what, double value) {
    return p.place.error(ErrorCode::Parse, fmt::format("{} {} has {} {}, expected more than 0", p.type, p.name, what, value));
}

Result<SurfaceMesh> polygonMesh(const Primitive& p) {
    SurfaceMesh mesh;
    mesh.positions = withHolesReversed(cornersOf(p));
    if (!obj::triangulate(mesh.positions, mesh.triangles))
        return p.place.error(ErrorCode::Unsupported, fmt::format("polygon {} is concave and has {} corners, expected at most {}", p.name,
                                                                 mesh.positions.size(), obj::kMaxConcaveCorners));
    std::erase_if(mesh.triangles, [&](const auto& t) {
        return !(triangleArea(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]) > 0);
    });
    if (p.normals.size() == mesh.positions.size()) mesh.normals = p.normals;
    return mesh;
}

Result<SurfaceMesh> sphereMesh(const Primitive& p, const Fineness& fineness) {
    const Vec3d centre(p.numbers[0], p.numbers[1], p.numbers[2]);
    const double radius = std::abs(p.numbers[3]);
    if (!(radius > 0)) return wrongSize(p, "the radius", radius);
    const int n = segmentsOf(radius, fineness), rings = n / 2;
    SurfaceMesh mesh;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < n; ++j) {
            const double theta = kPiD * i / rings, phi = 2 * kPiD * j / n;
            mesh.normals.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
        }
    for (const auto& normal : mesh.normals) mesh.positions.push_back(normal);
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < n; ++j) {
            const auto a = static_cast<Index>(i * n + j), b = static_cast<Index>(i * n + (j + 1) % n);
            const auto c = a + static_cast<Index>(n), d = b + static_cast<Index>(n);
            if (i > 0) mesh.triangles.push_back({a, c, b});
            if (i + 1 < rings) mesh.triangles.push_back({b, c, d});
        }
    const double scale = fineness.areaTrue ? radius * std::sqrt(4 * kPiD / mesh.area()) : radius;
    for (auto& position : mesh.positions) position = centre + position * scale;
    if ((p.type == "bubble") != (p.numbers[3] < 0)) turnInwards(mesh);  // Radiance: a negative radius is the other one
    return mesh;
}

/// A band between two circles about an axis: cylinders, cones and, with no height, rings.
struct Band {
    Vec3d start{0, 0, 0}, end{0, 0, 0}, axis{0, 0, 1};
    double r0 = 0, r1 = 0;
    bool smooth = true;
};

SurfaceMesh bandMesh(const Band& band, int n, double scale) {
    const auto [u, v] = across(band.axis);
    const double height = (band.end - band.start).dot(band.axis);
    SurfaceMesh mesh;
    for (int j = 0; j < n; ++j) {
        // Half a step on for the normal of a tip: a triangle's own, not its neighbour's.
        const auto around = [&](double step) { const double phi = 2 * kPiD * (j + step) / n; return u * std::cos(phi) + v * std::sin(phi); };
        const auto normal = [&](double step) { return (around(step) * height + band.axis * (band.r0 - band.r1)).normalized(); };
        mesh.positions.push_back(band.start + around(0) * (band.r0 * scale));
        mesh.positions.push_back(band.end + around(0) * (band.r1 * scale));
        if (!band.smooth) continue;
        mesh.normals.push_back(normal(band.r0 > 0 ? 0 : 0.5));
        mesh.normals.push_back(normal(band.r1 > 0 ? 0 : 0.5));
    }
    for (int j = 0; j < n; ++j) {
        const auto a = static_cast<Index>(2 * j), b = a + 1;
        const auto c = static_cast<Index>(2 * ((j + 1) % n)), d = c + 1;
        if (band.r0 > 0) mesh.triangles.push_back({a, c, b});
        if (band.r1 > 0) mesh.triangles.push_back(band.r0 > 0 ? std::array{b, c, d} : std::array{a, d, b});
    }
    return mesh;
}

/// The band with the area that it has when it is round.
SurfaceMesh areaTrueBand(const Band& band, int n) {
    const double slant = std::hypot((band.end - band.start).length(), band.r1 - band.r0);
    const double area = kPiD * (band.r0 + band.r1) * slant;
    double scale = 1;
    for (int i = 0; i < 8; ++i) {  // nearly linear in the scale: each pass leaves a thousandth of the error
        const double now = bandMesh(band, n, scale).area();
        const bool flat = (band.end - band.start).length() == 0;
        scale *= flat ? std::sqrt(area / now) : area / now;
    }
    return bandMesh(band, n, scale);
}

Result<SurfaceMesh> roundMesh(const Primitive& p, const Fineness& fineness) {
    const auto& x = p.numbers;
    const bool ring = p.type == "ring";
    Band band{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
    band.r0 = x[6];
    band.r1 = ring || p.type == "cone" || p.type == "cup" ? x[7] : x[6];
    if (band.r0 < 0 || band.r1 < 0) return wrongSize(p, "the radius", std::min(band.r0, band.r1));
    if (!(std::max(band.r0, band.r1) > 0)) return wrongSize(p, "the radius", 0);
    band.axis = band.end - band.start;
    if (ring) {
        band.axis = band.end;
        band.end = band.start;
        if (band.r0 < band.r1) std::swap(band.r0, band.r1);  // so that the band faces along the axis
        band.smooth = false;
        if (band.r0 == band.r1) return wrongSize(p, "the width", 0);
    }
    if (!(band.axis.length() > 0)) return wrongSize(p, ring ? "a normal of length" : "the length", 0);
    band.axis.normalize();
    const int n = segmentsOf(std::max(band.r0, band.r1), fineness);
    auto mesh = fineness.areaTrue ? areaTrueBand(band, n) : bandMesh(band, n, 1);
    if (p.type == "tube" || p.type == "cup") turnInwards(mesh);
    return mesh;
}

}  // namespace

double SurfaceMesh::area() const {
    double sum = 0;
    for (const auto& t : triangles) sum += triangleArea(positions[t[0]], positions[t[1]], positions[t[2]]);
    return sum;
}

Result<SurfaceMesh> tessellate(const Primitive& surface, const Fineness& fineness) {
    if (auto sized = checkArguments(surface); !sized) return sized.error();
    if (surface.type == "polygon") return polygonMesh(surface);
    auto mesh = surface.type == "sphere" || surface.type == "bubble" ? sphereMesh(surface, fineness) : roundMesh(surface, fineness);
    if (mesh && fineness.areaTrue) mesh->normals.clear();  // emission goes by the triangles' own normals
    return mesh;
}

double areaMismatch(const SurfaceMesh& mesh) {
    const auto& corners = mesh.positions;
    Vec3d normal(0, 0, 0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    const double expected = 0.5 * normal.length();
    return expected > 0 ? std::abs(mesh.area() / expected - 1) : 0;
}

}  // namespace luxdeck::rad
