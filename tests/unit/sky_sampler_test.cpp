#include "engine/sampling/sky_sampler.h"

#include "engine/algorithms/registry.h"
#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/scene/sky_models.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace luxdeck::test {
namespace {

const Vec3 kSunDirection = Vec3(0.3F, -0.7F, 0.6F).normalized();

Sky clearSky(bool withSun) {
    auto sky = cieClearSky(kSunDirection);
    if (withSun) sky.suns.push_back(Sun::ofNormalLux(kSunDirection, 80000));
    return scaledToHorizontal(std::move(sky), 15000);
}

/// A room of 6 x 6 x 3 m whose wall y = 0 has a window of 4 x 1.5 m, glazed or not; outside lies nothing.
Scene sideLitRoom(const Sky& sky, bool glazed, bool lamp = false) {
    SceneBuilder b;
    const auto walls = b.matte(0.6F), floor = b.matte(0.3F);
    b.quad({0, 0, 0}, {6, 0, 0}, {0, 6, 0}, floor).quad({0, 0, 3}, {0, 6, 0}, {6, 0, 0}, walls);
    b.quad({0, 0, 0}, {0, 6, 0}, {0, 0, 3}, walls).quad({6, 0, 0}, {0, 0, 3}, {0, 6, 0}, walls).quad({0, 6, 0}, {6, 0, 0}, {0, 0, 3}, walls);
    const auto front = [&](float x0, float x1, float z0, float z1, std::uint32_t m) { b.quad({x0, 0, z0}, {0, 0, z1 - z0}, {x1 - x0, 0, 0}, m); };
    front(0, 6, 0, 0.9F, walls), front(0, 6, 2.4F, 3, walls), front(0, 1, 0.9F, 2.4F, walls), front(5, 6, 0.9F, 2.4F, walls);
    if (glazed) {
        Material glass;
        glass.name = "glass", glass.kind = MaterialKind::ThinGlass, glass.transmittance = Rgb(0.8F);
        front(1, 5, 0.9F, 2.4F, b.material(glass));
    }
    if (lamp) b.lambertian({3, 4, 2.9F}, 500, {OpeningShape::Rectangle, 0.6, 0.6, 0});
    return b.sky(sky).build();
}

const std::array<SensorQuery, 4> kSensors{facing({3, 3, 0.75F}, {0, 0, 1}), facing({0.001F, 3, 1.5F}, {1, 0, 0}),
                                          facing({3, 4, 2.999F}, {0, 0, -1}), facing({3, 5, 1.2F}, {0.3F, -0.8F, 0.2F})};

TEST(SkyMap, TexelsAndDirectionsAgreeAndAreAlike) {
    std::vector<int> counts(SkyMap::kTexels);
    RandomStream random(5);
    for (std::uint32_t t = 0; t < SkyMap::kTexels; ++t)
        for (int i = 0; i < 20; ++i) {
            // Kept off the texel's border, where floats decide.
            const Vec2 u(static_cast<float>(0.01 + 0.98 * random.uniform()), static_cast<float>(0.01 + 0.98 * random.uniform()));
            const auto d = SkyMap::direction(t, u);
            EXPECT_NEAR(d.length(), 1, 1e-6);
            EXPECT_EQ(SkyMap::texelOf(d), t);
        }
    constexpr int kMean = 400;
    for (std::uint32_t i = 0; i < kMean * SkyMap::kTexels; ++i) {
        const double z = 2 * random.uniform() - 1, a = 2 * kPiD * random.uniform(), r = std::sqrt(1 - z * z);
        ++counts[SkyMap::texelOf(Vec3(Vec3d(r * std::cos(a), r * std::sin(a), z)))];
    }
    double chi2 = 0;
    for (const int c : counts) chi2 += (c - kMean) * (c - kMean) / static_cast<double>(kMean);
    // 1151 degrees of freedom: mean 1151, deviation 48; 4 of them are exceeded once in 30,000.
    EXPECT_LT(chi2, 1151 + 4 * 48);
}

TEST(SkySampler, DensitiesIntegrateToOneAndSamplesFollowThem) {
    const Lit lit(sideLitRoom(clearSky(true), true));
    ASSERT_TRUE(lit.sky && lit.sky->cells());
    for (const auto& at : {Receiver{{3, 3, 0.75F}, {0, 0, 1}}, Receiver{{3, 3, 2}, {0, 0, 0}}, Receiver{{30, 30, 0}, {0, 0, 1}},
                           Receiver{{0.001F, 3, 1.5F}, {1, 0, 0}, true}}) {
        double sum = 0;
        for (std::uint32_t t = 0; t < SkyMap::kTexels; ++t) sum += lit.sky->pdf(at, SkyMap::centre(t)) * SkyMap::kTexelSr;
        std::vector<double> counts(SkyMap::kTexels);
        constexpr int kSamples = 200'000;
        int suns = 0, border = 0;
        for (std::uint32_t i = 0; i < kSamples; ++i) {
            SamplePath path(77, i);
            const float select = path.next1D();
            const auto s = lit.sky->sample(at, select, path.next2D());
            ASSERT_GT(s.pdfSolidAngle, 0);
            if (!lit.scene.sky.sunRadiance(s.direction).isBlack() && s.radiance.g > 1e8F) {
                ++suns;
                continue;
            }
            if (std::abs(s.pdfSolidAngle - lit.sky->pdf(at, s.direction)) > 1e-5 * s.pdfSolidAngle) ++border;
            ++counts[SkyMap::texelOf(s.direction)];
        }
        // On a texel's border rounding may find the neighbour: a float's step over a texel's width, 1e-5 of all.
        EXPECT_LE(border, 20);
        EXPECT_NEAR(sum + static_cast<double>(suns) / kSamples, 1, 0.005);  // the share of suns is counted: 4 deviations of a Sobol' count are less
        double chi2 = 0;
        int bins = 0;
        for (std::uint32_t t = 0; t < SkyMap::kTexels; ++t) {
            const double expected = kSamples * static_cast<double>(lit.sky->pdf(at, SkyMap::centre(t))) * SkyMap::kTexelSr;
            if (expected < 5) continue;
            chi2 += (counts[t] - expected) * (counts[t] - expected) / expected, ++bins;
        }
        EXPECT_LT(chi2, bins + 4 * std::sqrt(2.0 * bins));  // Sobol' points lie more evenly than random ones: never a false alarm
    }
}

struct Means {
    MeanVariance direct, total;
};

Means measured(const TransportScene& scene, SensorQuery sensor, int samples, std::uint64_t seed) {
    const auto estimator = *makeEstimator("path", scene);
    Means means;
    std::vector<SensorQuery> queries(256, sensor);
    std::vector<SensorSample> out(queries.size());
    for (int done = 0; done < samples; done += 256) {
        for (std::size_t i = 0; i < queries.size(); ++i) queries[i].numbers = SamplePath(mix64(seed + static_cast<std::uint64_t>(done) + i), 0);
        estimator->irradiance(queries, out);
        for (const auto& s : out) means.direct.add(luminance(s.direct)), means.total.add(luminance(s.total()));
    }
    return means;
}

// Each comparison: two means of 16,384 samples each, |z| < 4.5: a false alarm in 150,000.
void expectSame(const MeanVariance& a, const MeanVariance& b, const char* what) {
    EXPECT_NEAR(a.mean(), b.mean(), 4.5 * std::sqrt(a.meanVariance() + b.meanVariance())) << what;
}

TEST(SkySampler, IsUnbiasedAgainstTheReceiversOwnDirections) {
    for (const bool lamp : {false, true}) {
        const Lit lit(sideLitRoom(clearSky(false), true, lamp));
        auto plain = lit.transport();
        plain.sky = nullptr;
        for (const auto& sensor : kSensors) {
            const auto with = measured(lit.transport(), sensor, 16384, 1), without = measured(plain, sensor, 16384, 2);
            expectSame(with.direct, without.direct, "direct");
            expectSame(with.total, without.total, "total");
        }
    }
}

TEST(SkySampler, SideLitPointsConverge) {
    const Lit lit(sideLitRoom(Sky(SkyKind::CieOvercast, 4000), true));
    auto plain = lit.transport();
    plain.sky = nullptr;
    const auto with = measured(lit.transport(), kSensors[0], 16384, 1), without = measured(plain, kSensors[0], 16384, 1);
    // Measured: 25 times. The direct part of a sample costs two rays more.
    EXPECT_LT(10 * with.direct.meanVariance(), without.direct.meanVariance());
}

TEST(SkySampler, ForcedNeedsAndThreadsChangeNothing) {
    const Scene scene = sideLitRoom(clearSky(true), true, true);
    const Lit lean(scene), full(scene, SceneNeeds::everything());
    expectSame(measured(lean.transport(), kSensors[0], 16384, 1).total, measured(full.transport(), kSensors[0], 16384, 3).total, "needs");
    std::vector<double> means;
    for (const int threads : {1, 2, 7}) {
        const ThreadLimit limit(threads);
        const Lit lit(scene);  // its cells are filled by these threads
        std::vector<double> values(16);
        parallelFor(values.size(), [&](std::size_t i) { values[i] = measured(lit.transport(), kSensors[i % kSensors.size()], 512, i / 4).total.mean(); });
        if (means.empty()) means = values;
        EXPECT_EQ(values, means) << threads;
    }
}

TEST(Suns, APatchGetsTheSunTimesTheCosine) {
    const Lit lit(sideLitRoom(clearSky(true), false));
    // The sun comes through the window: from (3, 1.2, 0) towards it the ray passes y = 0 at z = 1.03.
    const auto sunlit = measured(lit.transport(), facing({3, 1.2F, 0}, {0, 0, 1}), 16384, 1).direct;
    const Lit dim(sideLitRoom(clearSky(false), false));
    const auto sky = measured(dim.transport(), facing({3, 1.2F, 0}, {0, 0, 1}), 16384, 2).direct;
    const double expected = 80000 * kSunDirection.z;
    // The skies differ by their ground, which the sun lights: a floor point sees none of it.
    EXPECT_NEAR(sunlit.mean() - sky.mean(), expected, 4.5 * std::sqrt(sunlit.meanVariance() + sky.meanVariance()));
    const auto away = measured(lit.transport(), facing({3, 5, 0}, {0, 0, 1}), 16384, 3).direct;
    EXPECT_LT(away.mean(), 0.1 * expected);
}

TEST(Suns, ThroughAHoleOfOneCentimetre) {
    // A box of 3 m with a hole of 1 cm in its roof and the sun in the zenith: below it a part of the disc is seen, of the
    // solid angle 1e-4 / 9; E = L * that, to (0.005 / 3)^2 / 3 of itself.
    SceneBuilder b;
    const auto black = b.matte(0);
    b.quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, black);
    for (const float s : {-1.0F, 1.0F}) {
        b.quad({s, -1, 0}, {0, 2, 0}, {0, 0, 3}, black).quad({-1, s, 0}, {2, 0, 0}, {0, 0, 3}, black);
        b.quad({s > 0 ? 0.005F : -1, -1, 3}, {0.995F, 0, 0}, {0, 2, 0}, black);
        b.quad({-0.005F, s > 0 ? 0.005F : -1, 3}, {0.01F, 0, 0}, {0, 0.995F, 0}, black);
    }
    Sky sky;
    sky.suns.push_back(Sun::ofNormalLux({0, 0, 1}, 100000, Rgb(1.0F), 0.25 * kDegree));
    const Lit lit(b.sky(sky).build());
    const auto below = measured(lit.transport(), facing({0, 0, 0}, {0, 0, 1}), 65536, 1).direct;
    EXPECT_NEAR(below.mean(), sky.suns[0].radiance.g * 1e-4 / 9, 4.5 * std::sqrt(below.meanVariance()));
    EXPECT_LT(std::sqrt(below.meanVariance()), 0.02 * below.mean());
    EXPECT_EQ(measured(lit.transport(), facing({0.1F, 0, 0}, {0, 0, 1}), 16384, 1).direct.mean(), 0);
}

TEST(Suns, IlluminateOutdoorsWithoutNoise) {
    SceneBuilder b;
    b.quad({-50, -50, -1}, {100, 0, 0}, {0, 100, 0}, b.matte(0));
    const Lit lit(b.sky(clearSky(true)).build());
    EXPECT_EQ(lit.sky->cells(), nullptr);  // nothing is enclosed
    const auto up = measured(lit.transport(), facing({0, 0, 0}, {0, 0, 1}), 65536, 1).direct;
    EXPECT_NEAR(up.mean(), 15000 + 80000 * kSunDirection.z, 4.5 * std::sqrt(up.meanVariance()));
    EXPECT_LT(std::sqrt(up.meanVariance()), 0.01 * up.mean());
}

TEST(Suns, AreSeenByTheEyeInFull) {
    const Lit lit(sideLitRoom(clearSky(true), false));
    RadianceQuery query;
    query.ray = {{3, 1.2F, 0.01F}, 0, kSunDirection, kInfinity};
    RadianceSample sample;
    (*makeEstimator("path", lit.transport()))->radiance({&query, 1}, {&sample, 1});
    const auto& sky = lit.scene.sky;
    const float expected = sky.suns[0].radiance.g + sky.radiance(kSunDirection).g;
    EXPECT_NEAR(sample.emitted.g, expected, 1e-6 * expected);  // float
}

}  // namespace
}  // namespace luxdeck::test
