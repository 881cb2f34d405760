#include "engine/raycast/raycaster.h"

#include "engine/core/rng.h"
#include "engine/io/scene_files.h"
#include "tests/support/openings.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace luxdeck::test {
namespace {

Vec3 randomDirection(RandomStream& r) {
    return Vec3(static_cast<float>(r.normal()), static_cast<float>(r.normal()), static_cast<float>(r.normal())).normalized();
}
Vec3 randomIn(RandomStream& r, float side) {
    return {static_cast<float>(r.uniform()) * side, static_cast<float>(r.uniform()) * side, static_cast<float>(r.uniform()) * side};
}

std::vector<Hit> trace(const Raycaster& caster, const std::vector<Ray>& rays, Targets targets = Targets::Everything) {
    std::vector<Hit> hits(rays.size());
    caster.closestHits(rays, hits, targets);
    return hits;
}
Hit traceOne(const Raycaster& caster, const Ray& ray, Targets targets = Targets::Everything) { return trace(caster, {ray}, targets)[0]; }

/// Triangles, panes and openings of all sizes, all over a cube of 10 m.
Scene soup(std::uint64_t seed) {
    RandomStream r(seed);
    SceneBuilder b;
    Material glass;
    glass.kind = MaterialKind::ThinGlass, glass.transmittance = Rgb(0.9F);
    const auto opaque = b.matte(0.5F), pane = b.material(glass);
    for (int m = 0; m < 4; ++m) {
        Mesh mesh;
        mesh.material = m % 2 == 0 ? opaque : pane;
        for (std::uint32_t t = 0; t < 60; ++t) {
            const float size = std::pow(10.0F, -2.0F * static_cast<float>(r.uniform()) + 0.5F);
            const Vec3 at = randomIn(r, 10);
            for (int k = 0; k < 3; ++k) mesh.positions.push_back(at + randomDirection(r) * size);
            mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        }
        b.mesh(mesh);
    }
    for (const auto shape : kExtendedShapes) b.luminaire(randomIn(r, 10), axialTable([](double) { return 1.0; }), openingOf(shape), randomDirection(r));
    return b.build();
}

bool nearEdge(const Hit& hit) {
    return hit.opening() || std::min({hit.u, hit.v, 1 - hit.u - hit.v}) < 1e-4F;
}

// Distances differ by the kernel's float arithmetic: 1e-5 of the scene's 10 m at slanting triangles. Hits may differ
// only where two things are equally near or a ray passes within 1e-4 of an edge.
TEST(Raycaster, AgreesWithEveryRayAgainstEveryTriangle) {
    int hits = 0, disputed = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Scene scene = soup(seed);
        const auto fast = makeEmbreeRaycaster(scene);
        ASSERT_TRUE(fast) << fast.error().text();
        const auto oracle = makeBruteForceRaycaster(scene);
        RandomStream r(seed + 100);
        std::vector<Ray> rays;
        for (int i = 0; i < 4000; ++i) {
            Ray ray{randomIn(r, 10), 0, randomDirection(r), kInfinity};
            if (i % 3 == 1) ray.tMin = static_cast<float>(r.uniform());
            if (i % 3 == 2) ray.tMax = static_cast<float>(r.uniform()) * 5;
            rays.push_back(ray);
        }
        for (const auto targets : {Targets::Opaque, Targets::Panes, Targets::Openings, Targets::Surfaces, Targets::Everything}) {
            const auto got = trace(**fast, rays, targets), want = trace(*oracle, rays, targets);
            std::vector<std::uint8_t> occluded(rays.size()), should(rays.size());
            const bool flat = targets == Targets::Opaque || targets == Targets::Panes || targets == Targets::Surfaces;
            if (flat) (*fast)->occluded(rays, occluded, targets), oracle->occluded(rays, should, targets);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const auto &g = got[i], &w = want[i];
                hits += w.surface() || w.opening() ? 1 : 0;
                const bool same = g.mesh == w.mesh && g.triangle == w.triangle && g.luminaire == w.luminaire;
                const bool tie = std::abs(g.distance - w.distance) < 1e-4F;
                if (same && (tie || g.distance == w.distance)) {
                    if (flat) { EXPECT_EQ(occluded[i], should[i]); }
                } else if (!tie) {
                    ++disputed;
                    EXPECT_TRUE(nearEdge(g.distance < w.distance ? g : w)) << "ray " << i << " of soup " << seed;
                }
            }
        }
    }
    EXPECT_GT(hits, 10'000);
    EXPECT_LT(disputed, 10);
}

/// Rays from inside to all vertices, points of all edges, centres of all triangles, and anywhere.
std::vector<Ray> raysInto(const Scene& scene, const Vec3& from) {
    std::vector<Ray> rays;
    const auto add = [&](const Vec3& p) { rays.push_back({from, 0, (p - from).normalized(), kInfinity}); };
    for (const auto& mesh : scene.meshes) {
        for (const auto& p : mesh.positions) add(p);
        for (const auto& t : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                const Vec3 a = mesh.positions[t[static_cast<std::size_t>(k)]], b = mesh.positions[t[static_cast<std::size_t>((k + 1) % 3)]];
                for (const float s : {0.5F, 0.1F, 0.731F}) add(a + (b - a) * s);
            }
    }
    RandomStream r(1);
    for (int i = 0; i < 5000; ++i) rays.push_back({from, 0, randomDirection(r), kInfinity});
    return rays;
}

void expectNoneLost(const Scene& scene, const Vec3& from) {
    const auto caster = makeEmbreeRaycaster(scene);
    ASSERT_TRUE(caster);
    const auto rays = raysInto(scene, from);
    std::size_t lost = 0;
    for (const auto& hit : trace(**caster, rays)) lost += hit.surface() ? 0 : 1;
    EXPECT_EQ(lost, 0U) << "of " << rays.size();
    std::vector<std::uint8_t> occluded(rays.size());
    (*caster)->occluded(rays, occluded, Targets::Surfaces);
    EXPECT_EQ(std::count(occluded.begin(), occluded.end(), 0), 0);
}

// Bug class: light leaks through the seams of a closed room. Invariant: every ray from inside meets a wall, those
// aimed at a seam above all.
TEST(Raycaster, ClosedBodiesLoseNoRay) {
    SceneBuilder room;
    const Scene box = room.box({0, 0, 0}, {4.1F, 3.3F, 2.7F}, room.matte(0.5F), true, 7).build();
    expectNoneLost(box, {1.234F, 0.777F, 1.5F});
    expectNoneLost(box, {0.001F, 0.001F, 0.001F});
}

// Map coordinates: 10^6 m leave floats a spacing of 6 cm. Re-based, nothing is lost, and the origin is exact.
TEST(Raycaster, ClosedBodiesFarAwayLoseNoRayOnceRebased) {
    const Vec3d corner(1e6 + 0.1, 2e6 + 0.3, 412.7), size(4.1, 3.3, 2.7);
    const Vec3d origin = chooseOrigin(Box3d(corner, corner + size));
    ASSERT_NE(origin, Vec3d(0, 0, 0));
    EXPECT_EQ(origin, Vec3d(std::round(origin.x), std::round(origin.y), std::round(origin.z))) << "whole metres: an exact shift";
    const Vec3 low(corner - origin), high(corner + size - origin);
    SceneBuilder b;
    Scene scene = b.box(low, high, b.matte(0.5F), true, 7).build();
    scene.origin = origin;
    expectNoneLost(scene, (low + high) * 0.5F + Vec3(0.1F, 0.2F, 0.3F));
    EXPECT_LT((scene.toUser(low) - corner).length(), 1e-6);  // floats below 4 m are spaced 2.4e-7 m
}

TEST(Raycaster, BadRaysAreFlaggedAndHarmless) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Scene scene = soup(1);
    const auto embree = makeEmbreeRaycaster(scene);
    const auto brute = makeBruteForceRaycaster(scene);
    std::vector<Ray> bad;
    for (const float x : {nan, kInfinity, -kInfinity})
        for (int axis = 0; axis < 3; ++axis) {
            Ray origin, direction;
            origin.origin[axis] = x, direction.direction[axis] = x;
            bad.push_back(origin), bad.push_back(direction);
        }
    Ray negative, nanStart, nanEnd, negativeEnd;
    negative.tMin = -1e-6F, nanStart.tMin = nan, nanEnd.tMax = nan, negativeEnd.tMax = -1;
    bad.insert(bad.end(), {negative, nanStart, nanEnd, negativeEnd});
    for (const Raycaster* caster : std::initializer_list<const Raycaster*>{embree->get(), brute.get()}) {
        for (const auto& hit : trace(*caster, bad)) {
            EXPECT_TRUE(hit.badRay);
            EXPECT_FALSE(hit.surface() || hit.opening());
        }
        std::vector<std::uint8_t> occluded(bad.size(), 0);
        caster->occluded(bad, occluded, Targets::Surfaces);
        EXPECT_EQ(std::count(occluded.begin(), occluded.end(), 1), static_cast<std::ptrdiff_t>(bad.size()));
        EXPECT_FALSE(traceOne(*caster, Ray{}).badRay) << "an infinite end is fine";
    }
}

/// From below: a wall at z = 1, a pane at 2, an opening at 3, a dark luminaire's at 3.5, a wall at 4.
TEST(Raycaster, MasksChooseWhatIsMet) {
    SceneBuilder b;
    Material glass;
    glass.kind = MaterialKind::ThinGlass, glass.transmittance = Rgb(0.9F);
    const auto wall = b.matte(0.5F), pane = b.material(glass);
    b.quad({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}, wall).quad({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}, pane);
    b.lambertian({0, 0, 3.5F}, 0, openingOf(OpeningShape::Rectangle)).lambertian({0, 0, 3 + kFlushM}, 1, openingOf(OpeningShape::Rectangle));
    b.quad({-1, -1, 4}, {2, 0, 0}, {0, 2, 0}, wall);
    const Scene built = b.build();
    Scene scene = built;
    scene.luminaires[0].dimming = 0;
    const auto embree = makeEmbreeRaycaster(scene);
    const auto brute = makeBruteForceRaycaster(scene);
    for (const Raycaster* caster : std::initializer_list<const Raycaster*>{embree->get(), brute.get()}) {
        const Ray up{{0.3F, 0.1F, 0}, 0, {0, 0, 1}, kInfinity}, above{{0.3F, 0.1F, 1.5F}, 0, {0, 0, 1}, kInfinity};
        EXPECT_EQ(traceOne(*caster, up, Targets::Everything).mesh, 0U);
        EXPECT_EQ(traceOne(*caster, up, Targets::Panes).mesh, 1U);
        EXPECT_EQ(traceOne(*caster, above, Targets::Opaque).mesh, 2U);
        EXPECT_EQ(traceOne(*caster, above, Targets::Surfaces).mesh, 1U);
        const auto opening = traceOne(*caster, up, Targets::Openings);
        EXPECT_EQ(opening.luminaire, 1U) << "one that is switched off is not there";
        EXPECT_NEAR(opening.distance, 3, 1e-6F);  // float rounding
        EXPECT_FALSE(opening.surface());
        Ray beyond = up;
        beyond.tMin = 4.5F;
        EXPECT_EQ(traceOne(*caster, beyond).distance, kInfinity);
    }
}

TEST(Raycaster, AnEmptySceneIsMetByNothing) {
    const Scene scene;
    const auto caster = makeEmbreeRaycaster(scene);
    ASSERT_TRUE(caster) << caster.error().text();
    EXPECT_FALSE(traceOne(**caster, Ray{}).surface());
    EXPECT_NE((*caster)->kernel().find("Embree"), std::string::npos);
}

}  // namespace
}  // namespace luxdeck::test
