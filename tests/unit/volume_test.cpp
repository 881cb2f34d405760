// The irradiance volume: what its vertices see, how it interpolates, what walls stop.
#include "engine/volume/field.h"
#include "engine/volume/occupancy.h"
#include "engine/volume/visible_lookup.h"
#include "engine/volume/volume_build.h"
#include "engine/volume/volume_diff.h"

#include "engine/core/parallel.h"
#include "engine/core/rng.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace luxdeck::test {
namespace {

VolumeSettings small(int across = 3, int side = 9) {
    VolumeSettings s;
    s.firstLevel = {across, across, across}, s.side = side;
    return s;
}

IrradianceVolume built(const Lit& lit, const VolumeSettings& settings, const std::string& algorithm = "path", std::uint64_t seed = 1) {
    BuildOptions options;
    options.seed = seed;
    const Progress progress;
    auto volume = buildVolume(lit.transport(), *lit.estimator(algorithm), settings, options, progress);
    EXPECT_TRUE(volume) << (volume ? "" : volume.error().text());
    return *std::move(volume);
}

VolumeField fieldOf(const IrradianceVolume& volume, LightPart part = LightPart::Total, int order = 1, bool blend = false) {
    FieldSettings s;
    s.part = part, s.order = order, s.blendBins = blend;
    return VolumeField::make(volume, s).value();
}

/// A lattice of one cell with made-up radiances.
IrradianceVolume madeUp(int side, const std::function<Rgb(std::size_t vertex, int bin)>& radiance) {
    IrradianceVolume v;
    v.settings.side = side;
    v.lattice = Lattice::create({{0, 0, 0}, {1, 2, 3}}, {1, 1, 1}, 2, 1).value();
    v.quality.resize(8), v.sources.resize(8), v.occupied.resize(1);
    for (auto& q : v.quality) q.samples = 1;
    for (std::size_t i = 0; i < 8; ++i)
        for (int bin = 0; bin < v.bins().count(); ++bin) v.direct.push_back(Rgb{}), v.indirect.push_back(radiance(i, bin));
    return v;
}

TEST(Lattice, FindsThePlaceOfAPoint) {
    // Greger 1996, figure 4.12, with a third axis: a 4 x 2 grid of 32 x 18, the point (17, 12) lies in cell (2, 1) at 0.125, 0.333.
    const auto lattice = Lattice::create({{0, 0, 0}, {32, 18, 1}}, {4, 2, 1}, 2, 1).value();
    const auto place = lattice.locate({17, 12, 0.25F});
    EXPECT_EQ(place.cell, 6U);
    EXPECT_NEAR(place.fraction.x, 0.125F, 1e-6F);
    EXPECT_NEAR(place.fraction.y, 1.0F / 3, 1e-6F);
    EXPECT_NEAR(place.fraction.z, 0.25F, 1e-6F);
}

// Invariant: vertices that cells share are there once, and the corners of whatever cell a point is found in enclose it.
TEST(Lattice, SharesVerticesAndEnclosesPoints) {
    auto lattice = Lattice::create({{-1, 0, 2}, {1, 3, 5}}, {2, 3, 2}, 3, 2).value();
    RandomStream random(5);
    lattice.divideWhere([&](const Box3& box) { return box.intersects(Vec3(0.4F, 1.7F, 3.1F)); });
    std::vector<std::array<float, 3>> seen;
    for (const auto& v : lattice.vertices()) seen.push_back({v.x, v.y, v.z});
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(std::adjacent_find(seen.begin(), seen.end()), seen.end());
    EXPECT_EQ(lattice.cells().size(), 12U + 2 * 27);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p(static_cast<float>(2 * random.uniform() - 1), static_cast<float>(3 * random.uniform()), static_cast<float>(2 + 3 * random.uniform()));
        const auto place = lattice.locate(p);
        ASSERT_FALSE(lattice.divided(place.cell));
        const auto box = lattice.box(place.cell);
        for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(p[axis], box.min[axis] + place.fraction[axis] * (box.max[axis] - box.min[axis]), 2e-6F);
    }
}

TEST(Lattice, ComesBackFromItsChildren) {
    auto lattice = Lattice::create({{0, 0, 0}, {1, 1, 1}}, {3, 3, 3}, 2, 3).value();
    lattice.divideWhere([](const Box3& box) { return box.intersects(Vec3(0.5F, 0.5F, 0.5F)); });
    std::vector<std::uint32_t> children;
    for (const auto& cell : lattice.cells()) children.push_back(cell.firstChild);
    const auto again = Lattice::restore(lattice.bounds(), lattice.firstLevel(), 2, 3, children);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->vertices(), lattice.vertices());
    children[5] = 7;
    EXPECT_FALSE(Lattice::restore(lattice.bounds(), lattice.firstLevel(), 2, 3, children));
}

TEST(Occupancy, KnowsWhichBoxesATriangleTouches) {
    const std::array<Vec3, 3> t{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)};
    EXPECT_TRUE(touches(t, {{0.1F, 0.1F, -0.1F}, {0.2F, 0.2F, 0.1F}}));
    EXPECT_FALSE(touches(t, {{0.1F, 0.1F, 0.1F}, {0.2F, 0.2F, 0.3F}}));   // above it
    EXPECT_FALSE(touches(t, {{1.2F, 1.2F, -1}, {1.9F, 1.9F, 1}}));        // beyond the long side, within its bounds
    EXPECT_TRUE(touches(t, {{-1, -1, 0}, {3, 3, 1}}));                    // on its lower face
}

// Invariant: in a uniform field every point has pi L in every direction, to rounding (eight weights, 162 terms).
TEST(VolumeField, OfAUniformFieldIsPiL) {
    const auto volume = madeUp(9, [](std::size_t, int) { return Rgb(100, 50, 25); });
    const auto field = fieldOf(volume);
    RandomStream random(1);
    for (int i = 0; i < 500; ++i) {
        const Vec3 d(Vec3d(random.normal(), random.normal(), random.normal()).normalized());
        const auto c = field.at({static_cast<float>(random.uniform()), static_cast<float>(2 * random.uniform()), static_cast<float>(3 * random.uniform())}, d);
        ASSERT_NEAR(c.r, 100 * kPi, 100 * kPi * 2e-6);
        ASSERT_NEAR(c.b, 25 * kPi, 25 * kPi * 2e-6);
    }
}

// Closed form: one small source of irradiance 1000 lx throws 1000 max(0, cos) on a surface.
TEST(VolumeField, OfASmallSourceIsTheCosine) {
    auto volume = madeUp(17, [](std::size_t, int) { return Rgb{}; });
    const Vec3 source = Vec3(1, 2, -1).normalized();
    for (auto& list : volume.sources) list.push_back({source, Rgb(1000), true});
    const auto field = fieldOf(volume);
    for (int bin = 0; bin < volume.bins().count(); ++bin) {
        const Vec3 d = volume.bins().centre(bin);
        ASSERT_NEAR(field.at({0.3F, 0.4F, 0.5F}, d).g, 1000 * std::max(0.0F, dot(source, d)), 1e-3);
    }
}

// Invariant: trilinear interpolation is exact where light is a linear function of the place.
TEST(VolumeField, InterpolatesLinearFieldsExactly) {
    const auto volume = madeUp(3, [](std::size_t vertex, int) { return Rgb(static_cast<float>(vertex & 1U), static_cast<float>(vertex >> 1U & 1U), static_cast<float>(vertex >> 2U)); });
    const auto c = fieldOf(volume).at({0.25F, 1.5F, 0.6F}, {0, 0, 1});
    EXPECT_NEAR(c.r / kPi, 0.25, 1e-5);
    EXPECT_NEAR(c.g / kPi, 0.75, 1e-5);
    EXPECT_NEAR(c.b / kPi, 0.2, 1e-5);
}

// Invariant: irradiance is the moment of order 1, bit for bit, however it is asked for; the thesis' eq. 4.3 by hand.
TEST(VolumeField, MomentOneIsIrradianceBitForBit) {
    RandomStream random(2);
    const auto volume = madeUp(5, [&](std::size_t, int) { return Rgb(static_cast<float>(random.uniform())); });
    FieldSettings s;
    s.quadrature = Quadrature::Midpoint;
    const auto field = VolumeField::make(volume, s).value();
    const auto bins = volume.bins();
    std::vector<Vec3d> centres;
    for (int bin = 0; bin < bins.count(); ++bin) {
        auto d = concentricHemisphere((bin % 5 + 0.5) / 5, (bin / 5 % 5 + 0.5) / 5);
        if (bin >= 25) d.z = -d.z;
        centres.push_back(d.normalized());
    }
    for (std::size_t out = 0; out < centres.size(); ++out) {
        float sum = 0;
        for (std::size_t in = 0; in < centres.size(); ++in)
            sum += static_cast<float>(bins.solidAngleSr() * std::max(0.0, centres[in].dot(centres[out]))) * volume.indirectAt(3)[in].r;
        EXPECT_EQ(field.atVertex(3, field.look(bins.centre(static_cast<int>(out)))).r, sum);
    }
    EXPECT_EQ(queryDirection(1, {0, 0, 1}, {1, 0, 0}), Vec3(0, 0, 1));
    EXPECT_EQ(queryDirection(2, {0, 0, 1}, {1, 0, 0}), Vec3(-1, 0, 0));
}

// Harmonics of degree 4 hold the irradiance of a room with a lamp to 3 % (Ramamoorthi & Hanrahan 2001: degree 2 to 3 % on
// average, 9 % at worst), and say how well they did.
TEST(VolumeField, HarmonicsSayWhatTheyLeaveOut) {
    const Lit lit(cubeRoom(0.5F, 3000));
    const auto volume = built(lit, small());
    FieldSettings s;
    s.basis = Basis::Harmonics, s.degree = 4;
    const auto harmonics = VolumeField::make(volume, s).value(), bins = fieldOf(volume);
    EXPECT_LT(harmonics.bytes() * 6, bins.bytes());
    EXPECT_GT(harmonics.basisErrorRms(), 0);
    EXPECT_LT(harmonics.basisErrorRms(), 0.03);
    double error2 = 0, value2 = 0;
    for (std::uint32_t v = 0; v < volume.vertexCount(); ++v)
        for (int bin = 0; bin < volume.bins().count(); ++bin) {
            const Vec3 d = volume.bins().centre(bin);
            const double x = luminance(bins.atVertex(v, bins.look(d))), y = luminance(harmonics.atVertex(v, harmonics.look(d)));
            error2 += (x - y) * (x - y), value2 += x * x;
        }
    EXPECT_NEAR(std::sqrt(error2 / value2), harmonics.basisErrorRms(), 1e-4);
}

// A vertex sees what a sensor there measures: the same light by other code (gatherIlluminance). Direct and indirect apart,
// within 4.5 combined standard errors (false alarms 1e-5 for each of 2 x 3 x 12) and 0.4 %, which is what the 9 x 9 bins'
// piecewise constant directions may cost irradiance.
TEST(VolumeBuild, VerticesSeeWhatSensorsMeasure) {
    const Lit lit(furnishedRoom());
    auto settings = small(3, 17);
    settings.samplesPerBin = 16, settings.lightSamples = 256;
    const auto volume = built(lit, settings);
    const auto path = lit.estimator("path");
    int compared = 0;
    for (const std::uint32_t v : {4U, 13U, 22U}) {
        if (!volume.quality[v].usable()) continue;
        for (const Vec3& d : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, -1, 0)}) {
            const auto sensor = illuminance(lit, *path, facing(volume.lattice.vertices()[v], d), 0.01);
            const double noise = volume.quality[v].standardError();
            const auto direct = fieldOf(volume, LightPart::Direct, 1, true), indirect = fieldOf(volume, LightPart::Indirect, 1, true);
            const Vec3 p = volume.lattice.vertices()[v];
            EXPECT_NEAR(luminance(direct.at(p, d)), sensor.direct.value, 4.5 * std::hypot(noise, sensor.direct.standardError) + 0.004 * sensor.total.value) << v;
            EXPECT_NEAR(luminance(indirect.at(p, d)), sensor.indirect.value, 4.5 * std::hypot(noise, sensor.indirect.standardError) + 0.004 * sensor.total.value) << v;
            ++compared;
        }
    }
    EXPECT_GE(compared, 8);
}

// Luminaires add up: volumes of each alone against that of all, vertex by vertex in six directions, in units of their
// combined standard errors from 8 samples each: t values of some 14 degrees of freedom, whose rms over more than 100 is
// 1.08 +- 0.07. 1.5 is six deviations off.
TEST(VolumeBuild, LuminairesAddUp) {
    const auto scene = furnishedRoom();
    auto settings = small();
    settings.secondLevel = 1, settings.samplesPerBin = 8;
    const Lit lit(scene);
    const auto all = built(lit, settings);
    std::vector<IrradianceVolume> alone;
    for (std::size_t l = 0; l < scene.luminaires.size(); ++l) {
        auto one = scene;
        for (std::size_t i = 0; i < one.luminaires.size(); ++i)
            if (i != l) one.luminaires[i].dimming = 0;
        const Lit single(one);
        alone.push_back(built(single, settings, "path", 2 + l));
    }
    double sum2 = 0;
    int count = 0;
    for (std::size_t v = 0; v < all.vertexCount(); ++v) {
        for (std::size_t axis = 0; axis < 6; ++axis) {
            double difference = all.quality[v].lux[axis], noise2 = all.quality[v].variance(axis);
            for (const auto& one : alone) difference -= one.quality[v].lux[axis], noise2 += one.quality[v].variance(axis);
            if (!all.quality[v].usable() || !(noise2 > 0)) continue;
            sum2 += difference * difference / noise2, ++count;
        }
    }
    EXPECT_GT(count, 100);
    EXPECT_LT(std::sqrt(sum2 / count), 1.5);
}

// Invariant: direct + indirect = total, to 1e-6 of the light there.
TEST(VolumeBuild, PartsAddUp) {
    const auto scene = furnishedRoom();
    const Lit lit(scene);
    const auto volume = built(lit, small());
    const auto total = fieldOf(volume), direct = fieldOf(volume, LightPart::Direct), indirect = fieldOf(volume, LightPart::Indirect);
    for (std::uint32_t v = 0; v < volume.vertexCount(); ++v)
        for (int bin = 0; bin < volume.bins().count(); bin += 7) {
            const auto look = total.look(volume.bins().centre(bin));
            const double t = luminance(total.atVertex(v, look)), sum = luminance(direct.atVertex(v, look)) + luminance(indirect.atVertex(v, look));
            ASSERT_NEAR(sum, t, 1e-6 * t + 1e-6);
        }
}

// Invariant: the same bits at any number of threads, and at another lattice's vertices of the same places.
TEST(VolumeBuild, DependsOnNeitherThreadsNorLattice) {
    const Lit lit(furnishedRoom());
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return built(lit, small());
    };
    const auto one = with(1), two = with(2);
    EXPECT_EQ(one.indirect, two.indirect);
    auto undivided = small();
    undivided.secondLevel = 1;
    const auto coarse = built(lit, undivided);
    ASSERT_LT(coarse.vertexCount(), one.vertexCount());
    for (std::size_t v = 0; v < coarse.vertexCount(); ++v)
        for (std::size_t bin = 0; bin < coarse.binCount(); ++bin) ASSERT_EQ(coarse.indirectAt(v)[bin], one.indirectAt(v)[bin]);
}

/// Two rooms of 3 m behind a wall without thickness, a lamp of about 1,000 lx in one.
Scene thinWall() {
    SceneBuilder b;
    b.box({0, 0, 0}, {6, 3, 3}, b.matte(0.5F), true, 2);
    b.quad({3.2F, 0, 0}, {0, 3, 0}, {0, 0, 3}, b.matte(0.5F));
    b.isotropic({1.5F, 1.5F, 1.5F}, 25000);
    return b.build();
}

// Thin wall, 1,000 lx against dark: the leak in lx, of plain interpolation and of lookups that walls stop.
TEST(VisibleLookup, DoesNotLeakThroughAThinWall) {
    const Lit lit(thinWall());
    const auto volume = built(lit, small(4));
    const auto field = fieldOf(volume);
    const VisibleLookup visible(field, *lit.raycaster);
    std::vector<Vec3> positions, directions;
    for (int i = 0; i < 400; ++i) {
        const float y = 0.1F + 0.7F * static_cast<float>(i % 5), z = 0.1F + 0.7F * static_cast<float>(i / 5 % 5);
        const float behind = std::pow(10.0F, -4.0F + 0.27F * static_cast<float>(i / 25));  // 0.1 mm to 1.7 m behind the wall
        positions.emplace_back(3.2F + behind, y, z);
        directions.push_back(i % 2 == 0 ? Vec3(-1, 0, 0) : Vec3(0, 0, 1));
    }
    std::vector<Rgb> plain(positions.size()), stopped(positions.size());
    field.at(positions, directions, plain);
    const auto counters = visible.at(positions, directions, {}, stopped);
    double leak = 0, plainLeak = 0, lit1000 = 0;
    for (const auto& c : plain) plainLeak = std::max(plainLeak, double{luminance(c)});
    for (const auto& c : stopped) leak = std::max(leak, double{luminance(c)});
    lit1000 = luminance(field.at({1.5F, 1.5F, 0.5F}, {0, 0, 1}));
    EXPECT_GT(lit1000, 900);
    EXPECT_EQ(counters.nothing, 0U);
    EXPECT_LE(leak, 0.1) << "plain interpolation leaks " << plainLeak << " lx";
    EXPECT_GT(plainLeak, 100) << "the case does not show what it is about";
    RecordProperty("plainLeakLux", std::to_string(plainLeak));
}

// Before the wall nothing is lost, either.
TEST(VisibleLookup, KeepsTheLightBeforeTheWall) {
    const Lit lit(thinWall());
    const auto volume = built(lit, small(4));
    const auto field = fieldOf(volume);
    std::vector<Vec3> positions{{3.19F, 1.5F, 1.5F}}, directions{{-1, 0, 0}};
    std::vector<Rgb> value(1);
    VisibleLookup(field, *lit.raycaster).at(positions, directions, {}, value);
    const auto path = lit.estimator("path");
    const auto sensor = illuminance(lit, *path, facing(positions[0], directions[0]), 0.01);
    EXPECT_NEAR(luminance(value[0]), sensor.total.value, 0.25 * sensor.total.value);  // interpolation over half a metre of a lamp 1.7 m away
}

TEST(VolumeBuild, FindsVerticesInsideSolids) {
    SceneBuilder b;
    b.box({0, 0, 0}, {4, 4, 4}, b.matte(0.5F), true, 2);
    b.box({1.5F, 1.5F, 1.5F}, {2.5F, 2.5F, 2.5F}, b.matte(0.5F), false);
    b.isotropic({0.5F, 0.5F, 3.5F}, 3000);
    const Lit lit(b.build());
    const auto volume = built(lit, small());
    EXPECT_EQ(volume.unusable(), 1U);  // the middle of the room lies in the box
    EXPECT_FALSE(volume.quality[13].usable());
}

// Invariant: refinement goes where light changes, and lowers the measured error of interpolation.
TEST(VolumeBuild, RefinesWhereLightChanges) {
    const Lit lit(furnishedRoom());
    auto settings = small();
    settings.refineBelow = 0.5, settings.refineDepth = 1;
    const auto once = built(lit, settings);
    settings.refineDepth = 3;
    const auto deeper = built(lit, settings);
    EXPECT_GT(deeper.vertexCount(), once.vertexCount());
    EXPECT_GT(once.interpolationError, 0);
    settings.refineBelow = 5;
    EXPECT_EQ(built(lit, settings).vertexCount(), 27U);  // nothing differs that much
}

// The more samples, the less the error that the volume claims; and doubling goes on until the target is met.
TEST(VolumeBuild, SamplesUntilTheTargetIsMet) {
    const Lit lit(cubeRoom(0.5F, 3000));
    auto settings = small(2, 5);
    settings.secondLevel = 1, settings.samplesPerBin = 2;
    BuildOptions options;
    options.targetError = 0.01;
    const auto volume = buildVolume(lit.transport(), *lit.estimator("path"), settings, options, Progress{});
    ASSERT_TRUE(volume);
    EXPECT_LE(1.96 * volume->relativeError(), 0.01);
    EXPECT_GT(volume->quality[0].samples, 2U);
}

TEST(VolumeBuild, IgnoresWhatItIsToldTo) {
    auto scene = furnishedRoom();
    scene.objects[0].name = "walls";
    for (auto& mesh : scene.meshes) mesh.object = 0;
    const Lit lit(scene);
    auto settings = small();
    settings.ignored = {"walls"};
    const auto dark = built(lit, settings);
    for (const auto& c : dark.indirect) ASSERT_TRUE(c.isBlack());
    settings.ignored = {"no such thing"};
    EXPECT_FALSE(buildVolume(lit.transport(), *lit.estimator("path"), settings, {}, Progress{}));
}

TEST(VolumeBuild, RefusesWhatCannotBe) {
    SceneBuilder empty;
    const Lit nothing(empty.build());
    EXPECT_FALSE(buildVolume(nothing.transport(), *nothing.estimator("path"), small(), {}, Progress{}));
    const Lit lit(cubeRoom(0.5F, 1000));
    const auto refused = [&](const VolumeSettings& s) { return !buildVolume(lit.transport(), *lit.estimator("path"), s, {}, Progress{}); };
    auto s = small();
    s.side = 1;
    EXPECT_TRUE(refused(s));
    s = small(), s.firstLevel = {1, 3, 3};
    EXPECT_TRUE(refused(s));
    s = small(), s.sampling = BinSampling::Centres;  // with sources sought
    EXPECT_TRUE(refused(s));
    s = small(64, 64), s.firstLevel = {1025, 1025, 1025};
    EXPECT_TRUE(refused(s));
}

TEST(VolumeBuild, CancelledKeepsNothingUnfinished) {
    const Lit lit(cubeRoom(0.5F, 1000));
    Progress progress;
    progress.cancel();
    const auto volume = buildVolume(lit.transport(), *lit.estimator("path"), small(), {}, progress);
    ASSERT_TRUE(volume);
    EXPECT_FALSE(volume->complete);
    EXPECT_EQ(volume->unusable(), volume->vertexCount());
}

// A room without lights is dark, not refused.
TEST(VolumeBuild, OfADarkRoomIsDark) {
    SceneBuilder b;
    b.box({0, 0, 0}, {2, 2, 2}, b.matte(0.5F), true, 2);
    const Lit lit(b.build());
    const auto volume = built(lit, small());
    EXPECT_EQ(luminance(fieldOf(volume).at({1, 1, 1}, {0, 0, 1})), 0);
    EXPECT_EQ(volume.relativeError(), 0);
}

// Two volumes of other seeds differ by their noise: the ratio is 1 within the noise's own error (about 27 vertices of
// 3 samples in 6 directions: a factor of 2 is far off).
TEST(VolumeDifference, OfTwoSeedsIsTheirNoise) {
    const Lit lit(cubeRoom(0.5F, 3000));
    const auto a = built(lit, small(), "path", 1), b = built(lit, small(), "path", 2);
    const auto d = compareVolumes(a, b);
    ASSERT_TRUE(d);
    EXPECT_GT(d->total.rms, 0.4 * d->total.noise);
    EXPECT_LT(d->total.rms, 2 * d->total.noise);
    const auto self = volumeDifference(a, a);
    ASSERT_TRUE(self);
    EXPECT_NEAR(luminance(fieldOf(*self).at({1, 1, 1}, {0, 0, 1})), 0, 1e-3);
    EXPECT_FALSE(compareVolumes(a, built(lit, small(4))));
}

}  // namespace
}  // namespace luxdeck::test
