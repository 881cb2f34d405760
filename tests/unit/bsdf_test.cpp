#include "engine/transport/surface/bsdf.h"

#include "engine/core/rng.h"
#include "engine/sampling/sobol.h"
#include "tests/support/chi_square.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace luxdeck::test {
namespace {

Vec3 towards(float cosine, float turn = 0) {
    const float s = std::sqrt(std::max(0.0F, 1 - cosine * cosine));
    return {s * std::cos(turn), s * std::sin(turn), cosine};
}

template <Spectrum S>
Bsdf<S> bsdfOf(const Material& material) {
    static const Scene scene;
    SurfacePoint point;
    point.material = &material;
    return Bsdf<S>(scene, SceneNeeds::everything(), point);
}

/// Rough materials of all kinds, from none to all that they may reflect.
std::vector<Material> roughMaterials() {
    std::vector<Material> all;
    const auto add = [&](MaterialKind kind, const Rgb& reflectance, const Rgb& specular, float roughness, float metallic = 0) {
        Material m;
        m.kind = kind, m.reflectance = reflectance, m.specular = specular, m.roughness = roughness, m.metallic = metallic;
        m.name = "kind " + std::to_string(static_cast<int>(kind)) + " base " + std::to_string(reflectance.g) + " F0 " +
                 std::to_string(specular.g) + " roughness " + std::to_string(roughness) + " metallic " + std::to_string(metallic);
        all.push_back(m);
    };
    add(MaterialKind::Matte, {0.8F, 0.5F, 0.1F}, Rgb(0.0F), 0);
    add(MaterialKind::Matte, Rgb(1.0F), Rgb(0.0F), 0);
    for (const float roughness : {0.0F, 0.1F, 0.3F, 0.5F, 0.8F, 1.0F}) {
        for (const float f0 : {0.0F, 0.04F, 0.5F, 1.0F}) {
            for (const float base : {0.0F, 1.0F}) add(MaterialKind::Plastic, Rgb(base), Rgb(f0), roughness);
            add(MaterialKind::Metal, Rgb(0.0F), Rgb(f0), roughness);
        }
        for (const float metallic : {0.0F, 0.5F, 1.0F}) add(MaterialKind::MetallicRoughness, {1, 0.7F, 0.2F}, Rgb(0.0F), roughness, metallic);
    }
    return all;
}

/// Directional albedo by its own samples: 2^12 quasi-random points.
Rgb albedoBySamples(const Bsdf<Rgb>& bsdf, float cosine) {
    constexpr std::uint32_t kCount = 1 << 12;
    Rgb sum;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        SamplePath path(3, i);
        const float lobe = path.next1D();
        const auto s = bsdf.sample(towards(cosine), lobe, path.next2D());
        if (!s.absorbed) sum += s.weight;
    }
    return sum * (1.0F / kCount);
}

constexpr float kCosines[] = {0.02F, 0.1F, 0.3F, 0.6F, 0.9F, 1.0F};

// 3e-3: the albedo table is made of 1024-point sums and linear between its 32 x 32 nodes (measured: 2.5e-3 at roughness
// 0.3). Below the first node above zero, cosine 1/31, smooth coats still reflect too much: light at such angles
// carries 1e-3 of a hemisphere's flux, and the bound does not hold there.
TEST(Bsdf, NeverReflectsMoreThanItGets) {
    for (const auto& m : roughMaterials())
        for (const float cosine : kCosines) {
            if (cosine < 1.0F / 31) continue;
            const Rgb albedo = albedoBySamples(bsdfOf<Rgb>(m), cosine);
            EXPECT_LE(albedo.max(), 1 + 3e-3F) << m.name << " cosine " << cosine;
            EXPECT_GE(albedo.min(), 0.0F);
        }
}

// A white metal and a white base under any coat reflect everything: the furnace stays white. 2e-2: the table's mean
// by 32 nodes against its values at roughness 1 (measured: 1.5e-2 too little).
TEST(Bsdf, WhiteReflectsEverything) {
    for (const auto& m : roughMaterials()) {
        const bool white = (m.kind == MaterialKind::Metal && m.specular.g == 1) || (m.kind == MaterialKind::Plastic && m.reflectance.g == 1);
        if (!white) continue;
        for (const float cosine : kCosines) {
            if (cosine < 0.1F) continue;
            EXPECT_NEAR(albedoBySamples(bsdfOf<Rgb>(m), cosine).g, 1, 2e-2F) << m.name << " cosine " << cosine;
        }
    }
}

TEST(Bsdf, IsReciprocal) {
    RandomStream r(1);
    for (const auto& m : roughMaterials()) {
        const auto bsdf = bsdfOf<Rgb>(m);
        for (int i = 0; i < 300; ++i) {
            const auto direction = [&] { return towards(0.02F + 0.98F * static_cast<float>(r.uniform()), 6.28F * static_cast<float>(r.uniform())); };
            const Vec3 a = direction(), b = direction();
            const Rgb ab = bsdf.evaluate(a, b).cosineWeighted / b.z, ba = bsdf.evaluate(b, a).cosineWeighted / a.z;
            EXPECT_NEAR(ab.g, ba.g, 2e-4F * (ab.g + ba.g) + 1e-7F) << m.name;  // float rounding, largest in (1 - E)
        }
    }
}

TEST(Bsdf, WeightIsValueOverDensity) {
    RandomStream r(2);
    for (const auto& m : roughMaterials()) {
        const auto bsdf = bsdfOf<Rgb>(m);
        for (int i = 0; i < 200; ++i) {
            const Vec3 wo = towards(0.05F + 0.95F * static_cast<float>(r.uniform()));
            const auto s = bsdf.sample(wo, static_cast<float>(r.uniform()), {static_cast<float>(r.uniform()), static_cast<float>(r.uniform())});
            if (s.absorbed) continue;
            const auto value = bsdf.evaluate(wo, s.wi);
            EXPECT_NEAR(s.wi.length(), 1, 1e-4F);
            EXPECT_FLOAT_EQ(s.pdf, value.pdf);
            EXPECT_NEAR(s.weight.g * s.pdf, value.cosineWeighted.g, 1e-5F * value.cosineWeighted.g + 1e-12F) << m.name;
        }
    }
}

// Samples against the density of evaluate(); what falls below the horizon is absorbed, and counted as a bin of
// its own. z < 4: false alarm 3e-5 a case.
TEST(Bsdf, SamplesFollowTheirDensity) {
    constexpr int kZ = 10, kTurn = 16, kFine = 30, kCount = 1 << 15;
    for (const auto& m : roughMaterials()) {
        if (m.kind != MaterialKind::Matte && m.roughness < 0.4F) continue;  // midpoints would miss narrow lobes
        for (const float cosine : {0.2F, 0.8F}) {
            const auto bsdf = bsdfOf<Rgb>(m);
            const Vec3 wo = towards(cosine);
            std::vector<double> counts(kZ * kTurn + 1), expected(kZ * kTurn + 1);
            double total = 0;
            for (int z = 0; z < kZ * kFine; ++z)
                for (int t = 0; t < kTurn * kFine; ++t) {
                    const Vec3 wi = towards((static_cast<float>(z) + 0.5F) / (kZ * kFine), 2 * kPi * (static_cast<float>(t) + 0.5F) / (kTurn * kFine));
                    const double p = bsdf.evaluate(wo, wi).pdf * 2 * kPiD / (kZ * kFine * kTurn * kFine);
                    expected[static_cast<std::size_t>(z / kFine * kTurn + t / kFine)] += p * kCount, total += p;
                }
            ASSERT_LT(total, 1 + 1e-3) << m.name << ": the density integrates to at most 1; midpoints are good to 1e-3";
            expected.back() = kCount * std::max(0.0, 1 - total);
            RandomStream r(4);
            for (int i = 0; i < kCount; ++i) {
                const auto s = bsdf.sample(wo, static_cast<float>(r.uniform()), {static_cast<float>(r.uniform()), static_cast<float>(r.uniform())});
                const float turn = std::atan2(s.wi.y, s.wi.x) / (2 * kPi);
                const auto bin = [](float w, int n) { return std::clamp(static_cast<int>(w * static_cast<float>(n)), 0, n - 1); };
                ++counts[s.absorbed ? counts.size() - 1 : static_cast<std::size_t>(bin(s.wi.z, kZ) * kTurn + bin(turn < 0 ? turn + 1 : turn, kTurn))];
            }
            EXPECT_LT(chiSquareZ(counts, expected), 4) << m.name << " cosine " << cosine;
        }
    }
}

TEST(Bsdf, GreyAndColourAgreeOnGreyMaterials) {
    RandomStream r(5);
    for (const auto& m : roughMaterials()) {
        if (!m.reflectance.isGrey() || !m.specular.isGrey()) continue;
        const auto colour = bsdfOf<Rgb>(m);
        const auto grey = bsdfOf<Grey>(m);
        for (int i = 0; i < 100; ++i) {
            const Vec3 a = towards(0.02F + 0.98F * static_cast<float>(r.uniform())), b = towards(0.02F + 0.98F * static_cast<float>(r.uniform()), 2);
            const auto c = colour.evaluate(a, b);
            const auto g = grey.evaluate(a, b);
            // The chance of a lobe is weighed by a luminance in one, by the grey itself in the other: rounding.
            EXPECT_NEAR(c.cosineWeighted.g, g.cosineWeighted.y, 1e-5F * g.cosineWeighted.y) << m.name;
            EXPECT_NEAR(c.pdf, g.pdf, 1e-5F * g.pdf) << m.name;
        }
    }
}

TEST(Bsdf, NothingComesFromBelow) {
    for (const auto& m : roughMaterials()) {
        const auto bsdf = bsdfOf<Rgb>(m);
        EXPECT_TRUE(bsdf.evaluate({0, 0, 1}, {0, 0, -1}).cosineWeighted.isBlack());
        EXPECT_TRUE(bsdf.evaluate({0, 0, -1}, {0, 0, 1}).cosineWeighted.isBlack());
        EXPECT_EQ(bsdf.evaluate({0, 0, 1}, {1, 0, 0}).pdf, 0);
    }
}

TEST(Bsdf, AMirrorReflectsItsSpecularColourOneWay) {
    Material m;
    m.kind = MaterialKind::Mirror, m.specular = {0.9F, 0.8F, 0.7F};
    const auto bsdf = bsdfOf<Rgb>(m);
    ASSERT_TRUE(bsdf.specular());
    const auto s = bsdf.sample(towards(0.6F, 1), 0.5F, {0.5F, 0.5F});
    EXPECT_LT((s.wi - towards(0.6F, 1 + kPi)).length(), 1e-6F);  // float rounding
    EXPECT_EQ(s.weight, m.specular);
    EXPECT_EQ(s.pdf, 0);
    EXPECT_FALSE(s.passedThrough);
}

TEST(Bsdf, APaneReflectsAndTransmitsNoMoreThanItGets) {
    Material m;
    m.kind = MaterialKind::ThinGlass, m.transmittance = {0.9F, 0.7F, 0.4F};
    const auto bsdf = bsdfOf<Rgb>(m);
    for (const float cosine : kCosines) {
        Rgb reflected, transmitted;
        constexpr int kCount = 20'000;  // midpoints of uLobe: its one step is off by at most one of them
        for (int i = 0; i < kCount; ++i) {
            const auto s = bsdf.sample(towards(cosine), (static_cast<float>(i) + 0.5F) / kCount, {0.5F, 0.5F});
            (s.passedThrough ? transmitted : reflected) += s.weight * (1.0F / kCount);
        }
        EXPECT_LE((reflected + transmitted).max(), 1 + 1e-3F) << cosine;  // weights of up to 10 in steps of 1 / 20 000, float sums
        if (cosine == 1) { EXPECT_NEAR(transmitted.g, 0.7F, 1e-3F); }
    }
}

}  // namespace
}  // namespace luxdeck::test
