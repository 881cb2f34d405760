// Boundaries of solids, and solids inside solids, against closed forms. Statistical checks: |z| < 4, false alarm 6e-5
// each, 1e-3 over all of this file; seeds are fixed.
#include "engine/transport/surface/dielectric.h"

#include "engine/transport/surface/bsdf.h"
#include "engine/transport/tracer/media.h"
#include "tests/support/estimate.h"
#include "tests/support/eye.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace luxdeck::test {
namespace {

Vec3 towards(float cosine) { return {std::sqrt(std::max(0.0F, 1 - cosine * cosine)), 0, cosine}; }

Material solid(float ior, float transmittancePerMetre = 1) {
    Material m;
    m.kind = MaterialKind::Dielectric, m.ior = ior, m.transmittance = Rgb(transmittancePerMetre);
    return m;
}

TEST(Boundary, FollowsFresnelAndSnell) {
    EXPECT_NEAR(boundaryLight({0, 0, 1}, 1.5F).reflected, 0.04F, 1e-7F);
    EXPECT_NEAR(boundaryLight(towards(0.5F), 1.5F).reflected, 0.089186F, 1e-6F);  // by hand: rs^2 0.17657, rp^2 0.0018021
    const auto brewster = boundaryLight(towards(1 / std::sqrt(1 + 1.5F * 1.5F)), 1.5F);  // tan = n: rp is 0
    const float rs = (1 - 1.5F * 1.5F) / (1 + 1.5F * 1.5F);
    EXPECT_NEAR(brewster.reflected, 0.5F * rs * rs, 1e-6F);
    for (const float ratio : {0.5F, 0.75F, 1.0F, 1.33F, 2.4F})
        for (const float cosine : {1e-3F, 0.1F, 0.5F, 0.9F, 1.0F}) {
            const Vec3 wo = towards(cosine);
            const auto there = boundaryLight(wo, ratio);
            ASSERT_TRUE(there.reflected >= 0 && there.reflected <= 1);
            if (there.reflected == 1) continue;
            EXPECT_NEAR(there.refracted.length(), 1, 1e-6F);
            EXPECT_NEAR(there.refracted.x * ratio, -wo.x, 1e-6F) << "Snell";
            // Stokes: the way back reflects as much. There sin is near 1 / n, whose rounding of 6e-8 is, over cos^2, that of
            // the way out; R falls with 4 cos or less.
            const auto back = boundaryLight({-there.refracted.x, 0, -there.refracted.z}, 1 / ratio);
            EXPECT_NEAR(back.reflected, there.reflected, 2e-6F / cosine) << ratio << " " << cosine;
            EXPECT_LT((back.refracted + wo).length(), 2e-3F) << "the way back is the same";
        }
}

TEST(Boundary, ReflectsAllBeyondTheCriticalAngle) {
    const float critical = std::sqrt(1 - 1 / (1.5F * 1.5F));  // its cosine
    EXPECT_EQ(boundaryLight(towards(critical - 1e-3F), 1 / 1.5F).reflected, 1);
    EXPECT_LT(boundaryLight(towards(critical + 1e-3F), 1 / 1.5F).reflected, 0.9F);
    EXPECT_EQ(boundaryLight(towards(0), 1.5F).reflected, 1) << "grazing";
    EXPECT_EQ(boundaryLight(towards(0.3F), 1.0F).reflected, 0) << "no boundary at all";
    EXPECT_LT((boundaryLight(towards(0.3F), 1.0F).refracted + towards(0.3F)).length(), 1e-6F);
}

// White furnace of one boundary: what is reflected, and what is refracted times the squared ratio, make 1; the way
// there and back is reciprocal with the squared indices.
TEST(Boundary, LosesNothingAndIsReciprocal) {
    const Scene scene;
    const Material m = solid(1.5F);
    for (const bool front : {true, false})
        for (const float cosine : {0.05F, 0.4F, 0.8F, 1.0F}) {
            SurfacePoint point;
            point.material = &m, point.frontFace = front;
            const Bsdf<Grey> bsdf(scene, SceneNeeds::everything(), point);
            ASSERT_TRUE(bsdf.specular() && !bsdf.keepsImages());
            const float n2 = front ? 1.5F * 1.5F : 1 / (1.5F * 1.5F);
            double sum = 0;
            constexpr int kCount = 1000;
            for (int i = 0; i < kCount; ++i) {
                const auto s = bsdf.sample(towards(cosine), (static_cast<float>(i) + 0.5F) / kCount, {0.5F, 0.5F});
                EXPECT_EQ(s.pdf, 0);
                sum += s.refracted ? s.weight.y * n2 : s.weight.y;
                EXPECT_EQ(s.refracted, s.wi.z < 0);
            }
            EXPECT_NEAR(sum / kCount, 1, 1e-5);  // float rounding of n^2
        }
}

TEST(Media, RememberWhatIsInsideWhat) {
    const Material glass = solid(1.5F, 0.5F), water = solid(1.33F);
    Media media;
    EXPECT_EQ(media.ior(), 1);
    EXPECT_EQ(media.transmittance(7), Rgb(1.0F));
    ASSERT_TRUE(media.enter(glass));
    EXPECT_EQ(media.ior(), 1.5F);
    EXPECT_NEAR(media.transmittance(2).g, 0.25F, 1e-6F);
    EXPECT_EQ(media.iorAround(glass), 1);
    ASSERT_TRUE(media.enter(water));
    EXPECT_EQ(media.iorAround(water), 1.5F);
    EXPECT_EQ(media.iorAround(glass), 1.33F) << "the water goes on outside the glass";
    media.leave(glass);
    EXPECT_EQ(media.ior(), 1.33F);
    media.leave(glass);
    media.leave(water);
    EXPECT_TRUE(media.inAir());
    for (std::size_t i = 0; i < Media::kDeepest; ++i) EXPECT_TRUE(media.enter(glass));
    EXPECT_FALSE(media.enter(glass));
}

/// Plates of 40 m across about the axis, one inside the other, before an emitter of 1000 cd/m^2 at z = 3.
Scene plates(const std::vector<Material>& materials, const std::vector<float>& halfThickness) {
    SceneBuilder b;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const float h = halfThickness[i], w = 20 - static_cast<float>(i);
        b.box({-w, -w, -h}, {w, w, h}, b.material(materials[i]), false);
    }
    b.quad({-200, -200, 3}, {0, 400, 0}, {400, 0, 0}, b.glowing(1000, 0));
    return b.build();
}

/// What a stack of parallel layers reflects and lets through, from either side.
struct Layer {
    double r, t;
};
/// Adding method; symmetric layers alone, or stacks used from their first side.
Layer add(const Layer& a, double aBack, const Layer& b) {
    const double common = 1 / (1 - aBack * b.r);
    return {a.r + a.t * a.t * b.r * common, a.t * b.t * common};
}

double normalReflectance(double n1, double n2) { return (n1 - n2) * (n1 - n2) / ((n1 + n2) * (n1 + n2)); }

void expectSeen(const Seen& seen, double expected, const char* what) {
    EXPECT_NEAR(seen.value, expected, 4 * seen.standardError + 1e-5 * expected) << what;  // + float rounding
    EXPECT_EQ(seen.rejected, 0U) << what;
}

TEST(Solids, ASlabLetsThroughWhatTheClosedFormSays) {
    const double r = normalReflectance(1, 1.5), tau = std::pow(0.2, 0.5);  // half a metre of 0.2 a metre
    const Lit lit(plates({solid(1.5F, 0.2F)}, {0.25F}));
    EXPECT_TRUE(lit.needs.dielectrics && lit.needs.specularChains && !lit.needs.transmission);
    expectSeen(seenBy(lit, {0.3F, 0.2F, -2}, {0, 0, 1}), 1000 * (1 - r) * (1 - r) * tau / (1 - r * r * tau * tau), "straight");
    // Aslant, unpolarised at each boundary.
    const Vec3 d = towards(0.5F);
    const double ra = boundaryLight(d, 1.5F).reflected, ta = std::pow(tau, 1 / 0.81650);
    expectSeen(seenBy(lit, {-2, 0, -2}, d), 1000 * (1 - ra) * (1 - ra) * ta / (1 - ra * ra * ta * ta), "aslant");
}

TEST(Solids, WaterInGlass) {
    const double r1 = normalReflectance(1, 1.5), r2 = normalReflectance(1.5, 1.33);
    const double glass = std::pow(0.5, 0.1), water = std::pow(0.3, 0.4);
    // From the far side to the near: air | glass 0.1 m | water 0.4 m | glass 0.1 m | air.
    const auto slab = [](double tau) { return Layer{0, tau}; };
    const auto face = [](double r) { return Layer{r, 1 - r}; };
    Layer stack = face(r1);
    for (const auto& next : {slab(glass), face(r2), slab(water), face(r2), slab(glass), face(r1)}) stack = add(next, next.r, stack);
    const Lit lit(plates({solid(1.5F, 0.5F), solid(1.33F, 0.3F)}, {0.3F, 0.2F}));
    // face() reflects alike from both sides; only the emitter's side gives light, so the stack's t is what is seen.
    expectSeen(seenBy(lit, {0.3F, 0.2F, -2}, {0, 0, 1}, 1 << 14), 1000 * stack.t, "from outside");
}

// A point inside solids knows where it is. The emitter is all that shines: seen from the middle of the water.
TEST(Solids, AnEyeInsideKnowsItsSolids) {
    const Lit lit(plates({solid(1.5F, 0.5F), solid(1.33F, 0.3F)}, {0.3F, 0.2F}));
    TransportCounters counters;
    const auto media = mediaAt(lit.transport(), {0.3F, 0.2F, 0.01F}, counters);
    EXPECT_EQ(media.ior(), 1.33F);
    EXPECT_EQ(media.iorAround(lit.scene.materials[1]), 1.5F);
    EXPECT_EQ(mediaAt(lit.transport(), {0.3F, 0.2F, 0.25F}, counters).ior(), 1.5F);
    EXPECT_TRUE(mediaAt(lit.transport(), {0.3F, 0.2F, 0.35F}, counters).inAir());
    EXPECT_TRUE(mediaAt(lit.transport(), {0.3F, 0.2F, -1}, counters).inAir());
}

/// A solid under a sky that is alike everywhere, ground included.
Lit underUniformSky(const std::vector<Material>& nested, bool sphere) {
    SceneBuilder b;
    float size = 1;
    for (const auto& m : nested) {
        if (sphere) b.sphere({0, 0, 0}, size, b.material(m), false, 24);
        else b.box({-size, -size, -size}, {size, size, size}, b.material(m), false);
        size *= 0.6F;
    }
    b.sky({SkyKind::Uniform, 1000, 1.0, Rgb(1.0F)});
    return Lit(b.build());
}

// Clear solids change nothing in a uniform field; inside, radiance is larger by the squared index. Every path has
// weight 1 there but for Russian roulette. (From inside, a way that leaves a cube: others are reflected for ever.)
TEST(Solids, ClearOnesVanishInAUniformField) {
    for (const bool sphere : {true, false})
        for (const auto& nested : {std::vector{solid(1.5F)}, {solid(2.4F)}, {solid(1.0F)}, {solid(1.5F), solid(1.33F)}, {solid(1.33F), solid(1.5F)}}) {
            const Lit lit = underUniformSky(nested, sphere);
            expectSeen(seenBy(lit, {-3, 0.2F, 0.1F}, {1, 0.05F, 0.1F}), 1000, "from outside");
            const double n = nested.back().ior;
            expectSeen(seenBy(lit, {0.1F, 0.05F, 0.2F}, {0.1F, 0.15F, -0.98F}), 1000 * n * n, "from inside");
        }
}

// A lamp and a sensor in one solid: what is between them absorbs. A lamp outside, given as a point, lights nothing inside.
TEST(Solids, ShadowRaysInsideLoseLightToo) {
    SceneBuilder b;
    b.box({-2, -2, -2}, {2, 2, 2}, b.material(solid(1.0F, 0.3F)), false);
    b.isotropic({0, 0, 1}, 4 * kPiD * 1000);
    const Lit lit(b.build());
    SensorQuery sensor = facing({0, 0, -0.5F}, {0, 0, 1});
    SensorSample sample;
    (void)lit.estimator("path")->irradiance({&sensor, 1}, {&sample, 1});
    const double expected = 1000 / 2.25 * std::pow(0.3, 1.5);
    EXPECT_NEAR(sample.total().g, expected, 1e-4 * expected);  // a point lamp: float rounding, offset of the sensor
    sensor.position.z = -3;
    (void)lit.estimator("path")->irradiance({&sensor, 1}, {&sample, 1});
    EXPECT_EQ(sample.total().g, 0) << "shadow rays do not bend";
}

TEST(Solids, AbsorbingOnesNeverGiveMore) {
    const Lit lit = underUniformSky({solid(1.5F, 0.3F)}, true);
    const auto seen = seenBy(lit, {-3, 0.2F, 0.1F}, {1, 0.05F, 0.1F});
    EXPECT_LT(seen.value, 800);
    EXPECT_GT(seen.value, 40) << "what is reflected outside";
}

}  // namespace
}  // namespace luxdeck::test
