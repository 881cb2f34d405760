// What shadow rays keep of their light where they pass panes.
#include "engine/transport/tracer/shadow.h"

#include "engine/core/rng.h"
#include "engine/transport/surface/glass.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luxdeck::test {
namespace {

constexpr float kTransmittance = 0.8F, kIor = 1.52F;

Material glass() {
    Material m;
    m.kind = MaterialKind::ThinGlass, m.transmittance = Rgb(kTransmittance), m.ior = kIor;
    return m;
}

/// Square panes of 4 m, 12 mm apart from z = 1 up, each a mesh of its own or all in one.
Scene panes(int count, bool oneMesh) {
    SceneBuilder b;
    const auto material = b.material(glass());
    Mesh all;
    all.material = material;
    for (int i = 0; i < count; ++i) {
        const float z = 1 + 0.012F * static_cast<float>(i);
        if (!oneMesh) {
            b.quad({-2, -2, z}, {4, 0, 0}, {0, 4, 0}, material);
            continue;
        }
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), {{-2, -2, z}, {2, -2, z}, {2, 2, z}, {-2, 2, z}});
        all.triangles.insert(all.triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
    }
    if (oneMesh) b.mesh(all);
    return b.build();
}

float through(const Lit& lit, const Vec3& from, const Vec3& to) {
    TransportCounters counters;
    const Vec3 d = to - from;
    const float length = d.length();
    return paneTransmittance(lit.transport(), {from, 0, d / length, length}, counters).g;
}

float expectedFor(const Vec3& from, const Vec3& to, int count) {
    const float t = paneLight(Rgb(kTransmittance), kIor, std::abs((to - from).normalized().z)).transmitted.g;
    return std::pow(t, static_cast<float>(count));
}

// A pane's two triangles meet on its diagonal, where the kernel reports both. Invariant: one pane counts once.
TEST(PaneShadow, EveryPaneCountsOnceAlsoOnItsDiagonal) {
    for (const bool oneMesh : {true, false})
        for (const int count : {1, 2, 3}) {
            const Lit lit(panes(count, oneMesh));
            RandomStream r(1);
            for (int i = 0; i < 4000; ++i) {
                const float s = static_cast<float>(r.uniform()) * 3 - 1.5F, t = static_cast<float>(r.uniform()) * 0.4F;
                const Vec3 aim = i % 2 == 0 ? Vec3(s, s, 1) : Vec3(s, t, 1), from{t * 2, s * 0.3F, 0.2F};
                const Vec3 to = from + (aim - from) * 1.5F;
                // 1e-5: float rounding of the cosine, to the power of three panes.
                ASSERT_NEAR(through(lit, from, to), expectedFor(from, to, count), 1e-5F) << count << " panes, one mesh " << oneMesh;
            }
        }
}

TEST(PaneShadow, OnlyWhatLiesBetweenTheEnds) {
    const Lit lit(panes(1, false));
    EXPECT_EQ(through(lit, {0.1F, 0.3F, 0}, {0.1F, 0.3F, 0.99F}), 1.0F);
    EXPECT_EQ(through(lit, {0.1F, 0.3F, 1.01F}, {0.1F, 0.3F, 2}), 1.0F);
    EXPECT_EQ(through(lit, {9, 9, 0}, {9, 9, 2}), 1.0F);
}

// Bug: a shadow ray that lies in a pane, or grazes it, went round for ever: the kernel found the same pane again at
// a distance that rounding put behind the step taken past it. Invariant: it ends, with a transmittance in 0..1.
TEST(PaneShadow, RaysThatGrazeAPaneEnd) {
    RandomStream r(2);
    for (int scene = 0; scene < 20; ++scene) {
        SceneBuilder b;
        const Vec3 n = Vec3(static_cast<float>(r.normal()), static_cast<float>(r.normal()), static_cast<float>(r.normal())).normalized();
        const Frame f = Frame::about(scene % 4 == 0 ? Vec3(0, 0, 1) : n);
        const Vec3 corner{static_cast<float>(r.uniform()) * 50, static_cast<float>(r.uniform()) * 50, static_cast<float>(r.uniform())};
        b.quad(corner, f.tangent * 3.0F, f.bitangent * 2.0F, b.material(glass()), scene % 2 == 0 ? 1 : 4);
        const Lit lit(b.build());
        for (int i = 0; i < 1000; ++i) {
            const auto along = [&] { return static_cast<float>(r.uniform()) * 1.4F - 0.2F; };
            const auto tilt = [&] { return static_cast<float>(r.normal()) * std::pow(10.0F, -5.0F - 4.0F * static_cast<float>(r.uniform())); };
            const Vec3 from = corner + f.tangent * (3 * along()) + f.bitangent * (2 * along()) + f.normal * tilt();
            const Vec3 to = corner + f.tangent * (3 * along()) + f.bitangent * (2 * along()) + f.normal * tilt();
            const float t = through(lit, from, to);
            ASSERT_TRUE(t >= 0 && t <= 1) << t;
        }
    }
}

}  // namespace
}  // namespace luxdeck::test
