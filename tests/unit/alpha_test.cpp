// What is only partly there: holes by alpha, mixtures, panes of a Ward surface, patterns; and surfaces that shine by a
// picture or a pattern. Statistical checks: |z| < 4, false alarm 6e-5 each, 2e-3 over all of this file; seeds are fixed.
#include "engine/algorithms/registry.h"
#include "engine/scene/appearance.h"
#include "engine/transport/tracer/shadow.h"
#include "tests/support/estimate.h"
#include "tests/support/eye.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace luxdeck::test {
namespace {

/// A pattern given by a function.
class PatternOf : public Pattern {
public:
    explicit PatternOf(std::function<float(const PatternPoint&)> f) : f_(std::move(f)) {}
    [[nodiscard]] Rgb value(const PatternPoint& at) const override { return Rgb(f_(at)); }
    [[nodiscard]] std::string identity() const override { return "test"; }

private:
    std::function<float(const PatternPoint&)> f_;
};

std::shared_ptr<const Pattern> constant(float value) {
    return std::make_shared<PatternOf>([value](const PatternPoint&) { return value; });
}

Material matte(float reflectance) {
    Material m;
    m.reflectance = Rgb(reflectance);
    return m;
}

/// An emitter of 2 m x 1 m, 3 m above the origin, gives 203.626 lx there (1000 cd/m^2); a screen of the last material
/// that `change` leaves hangs half-way, unless it is null.
Scene behindScreen(const std::function<void(Scene&, Material&)>& change) {
    SceneBuilder b;
    const auto screen = b.material(matte(0));
    b.quad({-1, -0.5F, 3}, {0, 1, 0}, {2, 0, 0}, b.glowing(1000, 0));
    b.quad({-9, -9, 1.5F}, {18, 0, 0}, {0, 18, 0}, screen);
    Scene scene = b.build();
    Material m = scene.materials[screen];
    change(scene, m);
    scene.materials[screen] = m;
    const auto ok = validate(scene);
    EXPECT_TRUE(ok) << ok.error().text();
    return scene;
}

constexpr double kOpenLux = 203.626;

void expectLux(const Scene& scene, double expected, const char* what) {
    const Lit lit(scene), full(scene, SceneNeeds::everything());
    for (const auto* each : {&lit, &full})
        for (const auto& algorithm : algorithms()) {
            const auto e = illuminance(*each, *each->estimator(algorithm.name), facing({0, 0, 0}, {0, 0, 1}), 0.01);
            EXPECT_NEAR(e.total.value, expected, 4 * e.total.standardError + 1e-5 * expected) << what << " by " << algorithm.name;
        }
}

TEST(Straight, AScreenLetsThroughWhatItShould) {
    expectLux(behindScreen([](Scene&, Material&) {}), 0, "opaque");
    expectLux(behindScreen([](Scene&, Material& m) { m.alphaBlend = true, m.alpha = 0.25F; }), 0.75 * kOpenLux, "blend");
    expectLux(behindScreen([](Scene&, Material& m) { m.alphaCutoff = 0.5F, m.alpha = 0.4F; }), kOpenLux, "all a hole");
    expectLux(behindScreen([](Scene&, Material& m) { m.alphaCutoff = 0.3F, m.alpha = 0.4F; }), 0, "no hole");
    expectLux(behindScreen([](Scene&, Material& m) { m.kind = MaterialKind::Ward, m.specular = Rgb(0.0F), m.specularTransmittance = Rgb(0.6F); }),
              0.6 * kOpenLux, "a trans without roughness");
    expectLux(behindScreen([](Scene& s, Material& m) {
                  Material open;
                  open.kind = MaterialKind::ThinGlass, open.ior = 1, open.transmittance = Rgb(1.0F);
                  s.materials.insert(s.materials.end(), {open, matte(0)});
                  s.patterns.push_back(constant(0.35F));
                  m.kind = MaterialKind::Mix, m.mixPattern = 0;
                  m.mixFirst = static_cast<std::uint32_t>(s.materials.size() - 2), m.mixSecond = m.mixFirst + 1;
              }),
              0.35 * kOpenLux, "a mixture with nothing");
}

TEST(Straight, AMaskHasHolesWhereItsTexelsHave) {
    Scene scene = behindScreen([](Scene& s, Material& m) {
        Texture t;
        t.width = 2, t.height = 1, t.wrapU = t.wrapV = TextureWrap::Clamp;
        t.rgba = {255, 255, 255, 255, 255, 255, 255, 0};  // the second half is a hole
        s.textures.push_back(t);
        m.reflectanceTexture.texture = 0, m.alphaCutoff = 0.5F;
    });
    const auto& m = scene.materials[0];
    EXPECT_EQ(coverage(scene, m, {0.2F, 0.5F}), 1);
    EXPECT_EQ(coverage(scene, m, {0.8F, 0.5F}), 0);
    const Lit lit(std::move(scene));
    EXPECT_TRUE(lit.needs.alpha && lit.needs.transmission);
    TransportCounters counters;
    const auto through = [&](float x) { return paneTransmittance(lit.transport(), {{x, 0.3F, 0}, 0, {0, 0, 1}, 2}, counters).g; };
    EXPECT_EQ(through(-2), 0);
    EXPECT_EQ(through(2), 1);
    EXPECT_EQ(through(-0.001F), 0) << "u just below the middle";
}

// A lamp behind a sheet: all that comes through is scattered, found by next-event estimation from the sheet's far side.
TEST(Through, ALampBehindASheetLightsIt) {
    SceneBuilder b;
    Material m = matte(0.3F);
    m.kind = MaterialKind::Ward, m.specular = Rgb(0.0F), m.diffuseTransmittance = Rgb(0.5F);
    b.quad({-20, -20, 1}, {40, 0, 0}, {0, 40, 0}, b.material(m));
    b.isotropic({0.3F, 0.2F, 3}, 4 * kPiD * 1000);
    const Lit lit(b.build());
    EXPECT_TRUE(lit.needs.scatteredTransmission && !lit.needs.transmission);
    const double lux = 1000.0 / 4;  // at the foot, 2 m below
    const auto below = seenBy(lit, {0.3F, 0.2F, 0}, {0, 0, 1}, 64), above = seenBy(lit, {0.3F, 0.2F, 2}, {0, 0, -1}, 64);
    EXPECT_NEAR(below.value, 0.5 * lux / kPiD, 1e-4 * lux);  // a point lamp: no noise, float rounding
    EXPECT_NEAR(above.value, 0.3 * lux / kPiD, 1e-4 * lux);
}

// Surfaces that lose nothing vanish in a uniform field; no other gives more than the field.
TEST(Furnace, LosslessSurfacesVanishInAUniformField) {
    const auto seen = [](Scene& scene) {
        const Lit lit(scene);
        const auto s = seenBy(lit, {0.2F, 0.1F, 2}, {0.3F, 0.2F, -1}, 1 << 14);
        EXPECT_EQ(s.rejected, 0U);
        return s;
    };
    const auto sheet = [](const Material& m) {
        SceneBuilder b;
        b.quad({-4, -4, 1}, {8, 0, 0}, {0, 8, 0}, b.material(m));
        b.quad({-4, -4, 0}, {8, 0, 0}, {0, 8, 0}, b.material(m));  // interreflection
        b.sky({SkyKind::Uniform, 1000, 1.0, Rgb(1.0F)});
        return b.build();
    };
    Material white = matte(1), mirror, blend = matte(1), ward, rough, pane;
    mirror.kind = MaterialKind::Mirror, mirror.specular = Rgb(1.0F);
    blend.alphaBlend = true, blend.alpha = 0.3F;
    ward.kind = MaterialKind::Ward, ward.reflectance = Rgb(0.2F), ward.specular = Rgb(0.3F);
    ward.diffuseTransmittance = Rgb(0.1F), ward.specularTransmittance = Rgb(0.4F);
    pane.kind = MaterialKind::ThinGlass, pane.transmittance = Rgb(1.0F);
    for (const auto& m : {white, mirror, blend, ward, pane}) {
        Scene scene = sheet(m);
        const auto s = seen(scene);
        EXPECT_NEAR(s.value, 1000, 4 * s.standardError + 0.02) << static_cast<int>(m.kind);  // float rounding of sums
    }
    rough = ward, rough.wardU = 0.3F, rough.wardV = 0.5F;
    Scene scene = sheet(rough);
    const auto s = seen(scene);
    EXPECT_LT(s.value, 1000 + 4 * s.standardError);
    EXPECT_GT(s.value, 800) << "a wide Ward lobe loses what would go below the horizon, here 14 % over both sheets";
}

/// The emitter alone, its picture or pattern changed.
Scene emitter(const std::function<void(Scene&, Material&)>& change) {
    return behindScreen([&](Scene& s, Material& screen) {
        screen.alphaCutoff = 1, screen.alpha = 0;  // the screen is a hole
        change(s, s.materials[1]);
    });
}

TEST(Emission, ByAPictureAndByAPattern) {
    const auto picture = [](std::vector<std::uint8_t> rgba) {
        return emitter([rgba](Scene& s, Material& m) {
            Texture t;
            t.srgb = false, t.wrapU = t.wrapV = TextureWrap::Clamp, t.height = 1;
            t.width = static_cast<int>(rgba.size() / 4), t.rgba = rgba;
            s.textures.push_back(t);
            m.emissionTexture.texture = 0;
        });
    };
    expectLux(picture({51, 51, 51, 255}), 0.2 * kOpenLux, "a fifth");
    // Half black: by symmetry half the light, the bilinear ramp in the middle being symmetrical too.
    expectLux(picture({0, 0, 0, 255, 255, 255, 255, 255}), 0.5 * kOpenLux, "half black");

    const auto pattern = emitter([](Scene& s, Material& m) {
        s.patterns.push_back(std::make_shared<PatternOf>([](const PatternPoint& at) { return -5 * dot(at.normal, at.direction); }));
        m.emissionPattern = 0;
    });
    double expected = 0;  // midpoints, good to 1e-5
    constexpr int kN = 400;
    for (int i = 0; i < kN; ++i)
        for (int j = 0; j < kN; ++j) {
            const double x = -1 + 2 * (i + 0.5) / kN, y = -0.5 + (j + 0.5) / kN, d2 = x * x + y * y + 9, c = 3 / std::sqrt(d2);
            expected += 5000 * c * c * c / d2 * 2.0 / (kN * kN);
        }
    expectLux(pattern, expected, "a directional pattern");
}

TEST(Patterns, MultiplyReflectanceAndAreBounded) {
    for (const auto& [factor, seen] : {std::pair{0.5F, 0.25}, std::pair{7.0F, 1.0}}) {
        Scene scene = behindScreen([factor = factor](Scene& s, Material& m) {
            m = matte(0.5F), m.reflectancePattern = 0;
            s.patterns.push_back(constant(factor));
        });
        scene.meshes[0].triangles.clear();  // no emitter: the sky alone
        scene.sky = {SkyKind::Uniform, 1000, 1.0, Rgb(1.0F)};
        const auto s = seenBy(Lit(scene), {0, 0, 3}, {0.1F, 0.2F, -1});
        EXPECT_NEAR(s.value, 1000 * seen, 4 * s.standardError + 0.02);  // float rounding of sums
    }
}

TEST(Patterns, WhatHasNoValueIsRejectedAndCounted) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto count = [](const Scene& scene, const Vec3& from, const Vec3& to) { return seenBy(Lit(scene), from, to, 64).rejected; };
    EXPECT_EQ(count(behindScreen([&](Scene& s, Material& m) { m.reflectancePattern = 0, s.patterns.push_back(constant(nan)); }), {0, 0, 0}, {0, 0, 1}), 64U);
    EXPECT_EQ(count(emitter([&](Scene& s, Material& m) { m.emissionPattern = 0, s.patterns.push_back(constant(nan)); }), {0, 0, 0}, {0, 0, 1}), 64U);
    EXPECT_EQ(count(behindScreen([&](Scene& s, Material& m) {
                  m.kind = MaterialKind::Mix, m.mixPattern = 0, m.mixFirst = m.mixSecond = 1, s.patterns.push_back(constant(nan));
              }),
              {0, 0, 0}, {0, 0, 1}), 64U);
}

}  // namespace
}  // namespace luxdeck::test
