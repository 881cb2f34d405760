#include "engine/raycast/raycaster.h"
#include "engine/scene/opening.h"

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace luxdeck {

namespace {

bool includes(Targets targets, Targets one) {
    return (static_cast<unsigned>(targets) & static_cast<unsigned>(one)) != 0;
}

struct TriangleHit {
    double distance, u, v;
};

/// Watertight: the same signed edge volumes decide for both triangles of an edge.
/// Source: Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", in double.
std::optional<TriangleHit> meetTriangle(const Vec3d& origin, const Vec3d& direction, const Vec3d& p0, const Vec3d& p1,
                                        const Vec3d& p2) {
    int kz = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(direction[axis]) > std::abs(direction[kz])) kz = axis;
    int kx = (kz + 1) % 3, ky = (kx + 1) % 3;
    if (direction[kz] < 0) std::swap(kx, ky);
    const double sx = direction[kx] / direction[kz], sy = direction[ky] / direction[kz], sz = 1 / direction[kz];

    const Vec3d a = p0 - origin, b = p1 - origin, c = p2 - origin;
    const double ax = a[kx] - sx * a[kz], ay = a[ky] - sy * a[kz];
    const double bx = b[kx] - sx * b[kz], by = b[ky] - sy * b[kz];
    const double cx = c[kx] - sx * c[kz], cy = c[ky] - sy * c[kz];
    const double u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
    const double determinant = u + v + w;
    if (determinant == 0) return std::nullopt;
    const double t = (u * sz * a[kz] + v * sz * b[kz] + w * sz * c[kz]) / determinant;
    return TriangleHit{t, v / determinant, w / determinant};
}

class BruteForceRaycaster final : public Raycaster {
public:
    explicit BruteForceRaycaster(const Scene& scene) : scene_(scene) {
        for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
            const auto& l = scene.luminaires[i];
            const auto& type = scene.luminaireTypes[l.type];
            const auto placed = PlacedOpening::of(l, type.photometry.opening);
            if (placed.shape != OpeningShape::Point && runningLumens(l, type) > 0)
                openings_.emplace_back(placed, static_cast<std::uint32_t>(i));
        }
    }

    void closestHits(std::span<const Ray> rays, std::span<Hit> hits, Targets targets) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = closest(rays[i], targets);
    }

    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> out, Targets targets) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto hit = closest(rays[i], targets);
            out[i] = hit.badRay || hit.surface() || hit.opening() ? 1 : 0;
        }
    }

    [[nodiscard]] std::string kernel() const override { return "brute force"; }
    [[nodiscard]] std::size_t bytes() const override { return openings_.capacity() * sizeof(openings_[0]); }

private:
    [[nodiscard]] Hit closest(const Ray& ray, Targets targets) const {
        Hit best;
        if (!isGood(ray)) {
            best.badRay = true;
            return best;
        }
        best.distance = ray.tMax;
        for (std::size_t m = 0; m < scene_.meshes.size(); ++m) {
            const auto& mesh = scene_.meshes[m];
            const bool pane = scene_.letsStraightThrough(scene_.materials[mesh.material]);
            if (includes(targets, pane ? Targets::Panes : Targets::Opaque)) closestInMesh(ray, m, best);
        }
        if (includes(targets, Targets::Openings))
            for (const auto& [shape, luminaire] : openings_)
                if (const auto met = shape.intersect(ray.origin, ray.direction, ray.tMin, best.distance)) {
                    best = Hit{};
                    best.distance = met->distance;
                    best.luminaire = luminaire;
                }
        if (!best.surface() && !best.opening()) best.distance = kInfinity;
        return best;
    }

    void closestInMesh(const Ray& ray, std::size_t m, Hit& best) const {
        const auto& mesh = scene_.meshes[m];
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const auto& [a, b, c] = mesh.triangles[i];
            const auto met = meetTriangle(Vec3d(ray.origin), Vec3d(ray.direction), Vec3d(mesh.positions[a]),
                                          Vec3d(mesh.positions[b]), Vec3d(mesh.positions[c]));
            if (!met || !(met->distance > ray.tMin && met->distance < best.distance)) continue;
            best = Hit{};
            best.distance = static_cast<float>(met->distance);
            best.mesh = static_cast<std::uint32_t>(m);
            best.triangle = static_cast<std::uint32_t>(i);
            best.u = static_cast<float>(met->u), best.v = static_cast<float>(met->v);
        }
    }

    const Scene& scene_;
    std::vector<std::pair<PlacedOpening, std::uint32_t>> openings_;
};

}  // namespace

std::unique_ptr<Raycaster> makeBruteForceRaycaster(const Scene& scene) {
    return std::make_unique<BruteForceRaycaster>(scene);
}

}  // namespace luxdeck
