// The irradiance cache: gradients, what may use which record, set-up, and its light against that of paths.
#include "engine/transport/irradiance_cache/irradiance_cache.h"

#include "engine/core/parallel.h"
#include "engine/core/rng.h"
#include "engine/core/statistics.h"
#include "engine/transport/irradiance_cache/sight.h"
#include "engine/transport/irradiance_cache/surface_points.h"
#include "tests/support/estimate.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::test {
namespace {

std::unique_ptr<IrradianceCache> cacheOf(const Lit& lit, double effort, std::uint64_t seed = 1) {
    AlgorithmSettings settings;
    settings.effort = effort, settings.seed = seed;
    auto cache = makeIrradianceCache(lit.transport(), settings);
    EXPECT_TRUE(cache) << (cache ? "" : cache.error().text());
    return cache ? *std::move(cache) : nullptr;
}

std::vector<Rgb> askedOf(const IrradianceField& field, const std::vector<FieldPoint>& points) {
    std::vector<Rgb> lux(points.size());
    field.indirect(points, lux);
    return lux;
}

FieldPoint onFloor(float x, float y) {
    FieldPoint point;
    point.position = {x, y, 1e-6F};
    return point;
}

/// A glowing rectangle of 1000 cd/m^2, corners in order.
using Corners = std::array<Vec3d, 4>;
const Corners kPanel{Vec3d(0.4, -1, 1.5), Vec3d(0.4, 1, 1.5), Vec3d(2.4, 1, 1.2), Vec3d(2.4, -1, 1.2)};

/// Lambert's contour formula (LIGHTING-FACTS F.3); all of the panel is above the receiver's plane.
double panelLux(const Vec3d& at, const Vec3d& normal) {
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3d a = (kPanel[i] - at).normalized(), b = (kPanel[(i + 1) % 4] - at).normalized(), c = a.cross(b);
        sum += std::atan2(c.length(), a.dot(b)) * normal.dot(c.normalized());
    }
    return std::abs(sum) * 500;
}

/// Distance to the panel along a ray from the origin; infinite beside it.
double distanceToPanel(const Vec3d& direction) {
    const Vec3d u = kPanel[1] - kPanel[0], v = kPanel[3] - kPanel[0], n = u.cross(v);
    const double t = n.dot(kPanel[0]) / n.dot(direction);
    const Vec3d in = direction * t - kPanel[0];
    const double a = in.dot(u) / u.dot(u), b = in.dot(v) / v.dot(v);
    return t > 0 && a >= 0 && a <= 1 && b >= 0 && b <= 1 ? t : double{kInfinity};
}

// A cell is lit or not by one point of it: the panel's edge, of length 8 m at 2 m, crosses some 100 of 20,000 cells, each
// wrong by up to half of itself at random: 0.3 % of the irradiance. The gradients weigh cells by up to 5 times as much.
TEST(IrradianceGradients, AreThoseOfAPanelByFiniteDifferences) {
    const auto grid = HemisphereCells::about(20000);
    std::vector<HemisphereCell> cells;
    for (int i = 0; i < grid.count(); ++i) {
        const double distance = distanceToPanel(Vec3d(grid.direction(i, {0.5F, 0.5F})));
        cells.push_back({Rgb(std::isinf(distance) ? 0.0F : 1000.0F), static_cast<float>(distance)});
    }
    const auto found = irradianceAndGradients(grid, cells);
    const Vec3d up(0, 0, 1), origin(0, 0, 0);
    const double lux = panelLux(origin, up);
    EXPECT_NEAR(found.irradiance.g, lux, 0.005 * lux);
    constexpr double kStep = 1e-4;
    for (const auto& axis : {Vec3d(1, 0, 0), Vec3d(0, 1, 0)}) {
        const double moved = (panelLux(axis * kStep, up) - panelLux(axis * -kStep, up)) / (2 * kStep);
        EXPECT_NEAR(found.translation.along(Vec3(axis)).g, moved, 0.02 * lux) << axis.x;
        const double turned = (panelLux(origin, (up + axis * kStep).normalized()) - panelLux(origin, (up - axis * kStep).normalized())) / (2 * kStep);
        EXPECT_NEAR(found.rotation.along(Vec3(axis)).g, turned, 0.02 * lux) << axis.x;
    }
    EXPECT_GT(found.translation.along({1, 0, 0}).g, 0.1 * lux) << "towards the panel it grows: the test has something to see";
}

// Cells that differ by noise alone have no gradient to believe in: with independent noise its square is what noise makes
// of it, on average, and is cut to less.
TEST(IrradianceGradients, OfNoiseAreCut) {
    const auto grid = HemisphereCells::about(200);
    RandomStream random(5);
    double size2 = 0;
    int none = 0;
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<HemisphereCell> cells;
        for (int i = 0; i < grid.count(); ++i) cells.push_back({Rgb(static_cast<float>(random.uniform())), 1});
        const double size = irradianceAndGradients(grid, cells).translation.g.length2();
        size2 += size / 100, none += size == 0 ? 1 : 0;
    }
    EXPECT_GT(none, 40);
    EXPECT_LT(std::sqrt(size2), 0.15 * kPiD / 2);
}

IrradianceRecord recordAt(Vec3 position, float free) {
    IrradianceRecord record;
    record.position = position, record.distance = 2;
    record.horizon.distance.fill(free);
    return record;
}

TEST(Horizon, HasItsDirectionsWhereItLooksThemUp) {
    for (int k = 0; k < Horizon::kSectors; ++k) {
        const Vec3 d = Horizon::direction(k);
        EXPECT_NEAR(std::remainder(Horizon::sectorOf(d.x, d.y) - static_cast<float>(k), Horizon::kSectors), 0, 1e-4) << k;
    }
}

// In a plane the record's horizon tells, on bent surfaces rays; steps never share.
TEST(Sight, EndsAtWallsAndSteps) {
    SightRays rays;
    EXPECT_EQ(sightOf(recordAt({0, 0, 1e-6F}, 1), onFloor(0.9F, 0.1F), rays), Sight::Open);
    EXPECT_EQ(sightOf(recordAt({0, 0, 1e-6F}, 1), onFloor(1.1F, 0.1F), rays), Sight::Hidden);
    EXPECT_EQ(sightOf(recordAt({0, 0, 1e-6F}, 1), onFloor(1.0F, 0), rays), Sight::Asked) << "at the foot of the wall";
    // A shelf 2 cm above another: their points lie off both planes by as much, one up, one down.
    EXPECT_EQ(sightOf(recordAt({0, 0, 0.02F}, kInfinity), onFloor(0.1F, 0), rays), Sight::Hidden);
    EXPECT_EQ(sightOf(recordAt({0, 0, 0.02F}, kInfinity), onFloor(0.3F, 0), rays), Sight::Hidden);
}

TEST(Sight, GoesAroundAGentleBend) {
    // Points of a circle of radius 1 about the y axis, 0.2 apart: outside it the way leads over the bulge, inside straight.
    const auto onCircle = [](float angle, float side) {
        FieldPoint p;
        const Vec3 out(std::sin(angle), 0, std::cos(angle));
        p.position = out * (1 + side * 1e-5F), p.normal = p.geometricNormal = out * side;
        return p;
    };
    for (const float side : {1.0F, -1.0F}) {
        const auto from = onCircle(-0.1F, side), to = onCircle(0.1F, side);
        IrradianceRecord record;
        record.position = from.position, record.normal = record.geometricNormal = from.normal;
        SightRays rays;
        ASSERT_EQ(sightOf(record, to, rays), Sight::Asked);
        EXPECT_EQ(rays.count, side > 0 ? 2 : 1);
        for (int i = 0; i < rays.count; ++i) {
            const auto& ray = rays.rays[static_cast<std::size_t>(i)];
            for (float t = 0.1F; t < 1; t += 0.1F)
                EXPECT_GE(side * ((ray.origin + ray.direction * (t * ray.tMax)).length() - 1), 0) << "within the circle's own material";
        }
    }
}

// Krivanek's invariant, up to the step below which clamping ends (1 %) and for those within each other's reach.
TEST(IrradianceCache, ClampsNeighboursDistances) {
    const Lit lit(furnishedRoom());
    const auto cache = cacheOf(lit, 0.1);
    const auto records = cache->records();
    ASSERT_GT(records.size(), 300U);
    int pairs = 0;
    for (const auto& a : records)
        for (const auto& b : records) {
            const float apart = (a.position - b.position).length();
            if (&a == &b || dot(a.normal, b.normal) < 0.5F || apart > cache->accuracy().reach(a)) continue;
            ++pairs;
            EXPECT_LE(b.distance, (a.distance + apart) * 1.02F);
        }
    EXPECT_GT(pairs, 300);
}

/// Two rooms that share a wall without thickness; light in the first alone.
Lit dividedRoom() {
    SceneBuilder b;
    const auto white = b.matte(0.8F);
    b.box({0, 0, 0}, {8, 4, 3}, white, true).quad({4, 0, 0}, {0, 4, 0}, {0, 0, 3}, white);
    return Lit(b.isotropic({2, 2, 1.5F}, 10000).build());
}

TEST(IrradianceCache, DoesNotLeakThroughAWallWithoutThickness) {
    const auto lit = dividedRoom();
    const auto cache = cacheOf(lit, 1);
    std::vector<FieldPoint> dark, bright;
    for (const float away : {0.0005F, 0.001F, 0.01F, 0.03F, 0.1F, 0.3F})
        for (float y = 0.05F; y < 4; y += 0.1F) dark.push_back(onFloor(4 + away, y)), bright.push_back(onFloor(4 - away, y));
    for (const auto& lux : askedOf(*cache, dark)) EXPECT_EQ(lux, Rgb(0.0F));
    // The mean of the lit room's indirect light is lm rho / (A (1 - rho)) = 500 lx.
    double mean = 0;
    for (const auto& lux : askedOf(*cache, bright)) mean += lux.g / static_cast<double>(bright.size());
    EXPECT_NEAR(mean, 500, 100);
}

TEST(IrradianceCache, IsTheSameAtAnyNumberOfThreads) {
    const Lit lit(furnishedRoom());
    std::vector<FieldPoint> points;
    const SurfacePoints spread(lit.transport(), 11);
    for (std::uint32_t i = 0; i < 500; ++i) points.push_back(spread.at(i));
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return askedOf(*cacheOf(lit, 0.05), points);
    };
    const auto one = with(1);
    EXPECT_EQ(one, with(3));
    EXPECT_NE(one, askedOf(*cacheOf(lit, 0.05, 2), points)) << "another seed, another cache";
}

TEST(IrradianceCache, StopsWhenItIsCancelled) {
    const Lit lit(furnishedRoom());
    Progress before, during([&](const ProgressState&) { during.cancel(); });
    before.cancel();
    for (const auto* progress : {&before, &during}) {
        AlgorithmSettings settings;
        settings.progress = progress;
        const auto cache = makeIrradianceCache(lit.transport(), settings);
        ASSERT_FALSE(cache);
        EXPECT_EQ(cache.error().code, ErrorCode::Cancelled);
    }
}

TEST(IrradianceCache, RefusesSettingsOutOfRange) {
    const Lit lit(cubeRoom(0.5F, 1000));
    for (const double effort : {0.0, 1e4, std::nan("")}) {
        AlgorithmSettings settings;
        settings.effort = effort;
        const auto cache = makeIrradianceCache(lit.transport(), settings);
        ASSERT_FALSE(cache);
        EXPECT_EQ(cache.error().code, ErrorCode::InvalidArgument);
    }
}

TEST(IrradianceCache, OfDarkAndEmptyScenesIsDark) {
    SceneBuilder dark, bare;
    const Lit room(dark.box({0, 0, 0}, {4, 4, 4}, dark.matte(0.5F), true).build()), nothing(bare.isotropic({0, 0, 3}, 1000).build());
    for (const auto* lit : {&room, &nothing}) {
        const auto cache = cacheOf(*lit, 1);
        EXPECT_TRUE(cache->records().empty());
        EXPECT_EQ(askedOf(*cache, {onFloor(1, 1)}).front(), Rgb(0.0F));
    }
}

/// Points on the matte surfaces of a scene where light comes, and the indirect light there by many paths.
struct Reference {
    std::vector<FieldPoint> points;
    std::vector<Estimate> lux;

    Reference(const Lit& lit, std::uint32_t count) {
        const SurfacePoints spread(lit.transport(), 77);
        const auto path = lit.estimator("path");
        for (std::uint32_t i = 0; points.size() < count; ++i) {
            const auto point = spread.at(i);
            const SensorQuery sensor{point.position, point.normal, SensorKind::Planar, {}};
            const auto e = illuminance(lit, *path, sensor, 0.02, i + 1).indirect;
            if (e.value > 0) points.push_back(point), lux.push_back(e);
        }
    }
    /// Root of the mean squared relative deviation, without what the reference's own noise makes of it.
    [[nodiscard]] double deviation(const IrradianceField& field) const {
        const auto got = askedOf(field, points);
        double sum = 0;
        for (std::size_t i = 0; i < got.size(); ++i)
            sum += std::pow(luminance(got[i]) / lux[i].value - 1, 2) - std::pow(lux[i].standardError / lux[i].value, 2);
        return std::sqrt(std::max(sum, 0.0) / static_cast<double>(got.size()));
    }
};

// Records and their rays grow with the root of the effort each, so that noise falls with its fourth root, errors of
// interpolation with its root: 100 times the effort leaves at most a third. Half leaves room for what 150 points tell of it.
TEST(IrradianceCache, ErrsLessWithMoreEffort) {
    const Lit lit(furnishedRoom());
    const Reference reference(lit, 150);
    const double rough = reference.deviation(*cacheOf(lit, 0.02)), plain = reference.deviation(*cacheOf(lit, 0.2)), fine = reference.deviation(*cacheOf(lit, 2));
    EXPECT_LT(plain, rough);
    EXPECT_LT(fine, plain);
    EXPECT_LT(fine, 0.5 * rough);
    EXPECT_LT(fine, 0.05);
    RecordProperty("deviations", std::to_string(rough) + " " + std::to_string(plain) + " " + std::to_string(fine));
}

/// The registry's bias and 4.5 standard errors: of 100 comparisons with other seeds one such deviation is expected in
/// 100 runs, were there no room in the bias (Student's t, 31 degrees of freedom, 9e-5).
void expectLightOfPaths(const Lit& lit, const std::vector<SensorQuery>& sensors) {
    const auto cache = lit.estimator("irradiance_cache"), path = lit.estimator("path");
    EXPECT_GT(cache->bytes(), 10'000U);
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        const auto got = illuminance(lit, *cache, sensors[i], 0.01).total, expected = illuminance(lit, *path, sensors[i], 0.01, 2).total;
        EXPECT_NEAR(got.value, expected.value, 4.5 * std::hypot(got.standardError, expected.standardError) + 0.02 * expected.value) << "sensor " << i;
    }
}

std::vector<SensorQuery> sensorsIn(const Box3& box) {
    std::vector<SensorQuery> sensors;
    for (int i = 0; i < 9; ++i) {
        const Vec3 part(0.1F + 0.4F * static_cast<float>(i % 3), 0.1F + 0.4F * static_cast<float>(i / 3), 0.3F);
        const Vec3 normal = i % 2 == 0 ? Vec3(0, 0, 1) : Vec3(0, 1, 0.2F).normalized();
        sensors.push_back({box.min + box.size() * part, normal, i % 4 == 3 ? SensorKind::Cylindrical : SensorKind::Planar, {}});
    }
    return sensors;
}

TEST(IrradianceCache, HasTheLightOfPathsInAFurnishedRoom) {
    const Lit lit(furnishedRoom());
    auto sensors = sensorsIn(lit.scene.bounds());
    sensors.push_back(facing({3, 2, 0}, {0, 0, 1}));         // on the floor, under the pane
    sensors.push_back(facing({3, 1.5F, 0.74F}, {0, 0, 1}));  // on the table
    sensors.push_back(facing({3, 1.5F, 0}, {0, 0, 1}));      // below it
    expectLightOfPaths(lit, sensors);
}

/// Mean luminance over all directions from a point, with its standard error by 16 independent sets.
Estimate meanLuminance(const Lit& lit, const RadianceEstimator& estimator, Vec3 from, std::uint64_t seed) {
    MeanVariance sets;
    std::vector<RadianceQuery> queries(1024);
    std::vector<RadianceSample> samples(queries.size());
    for (std::uint64_t set = 0; set < 16; ++set) {
        for (std::uint32_t i = 0; i < queries.size(); ++i) {
            SamplePath numbers(streamSeed(seed, set), i);
            const Vec2 u = numbers.next2D();
            const float z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0F, 1 - z * z));
            queries[i].ray = {from, 0, {r * std::cos(2 * kPi * u.y), r * std::sin(2 * kPi * u.y), z}, kInfinity};
            queries[i].numbers = numbers;
        }
        estimator.radiance(queries, samples);
        double sum = 0;
        for (const auto& s : samples) sum += luminance(s.direct + s.indirect, lit.scene.weights);
        sets.add(sum / static_cast<double>(samples.size()));
    }
    return {sets.mean(), std::sqrt(sets.meanVariance())};
}

// Pictures take the cache at the first surface. The registry's bias and 5 standard errors (Student's t, 15 degrees of
// freedom each: 2e-4).
TEST(IrradianceCache, HasTheRadianceOfPaths) {
    for (const auto& room : {furnishedRoom(), richRoom()}) {
        const Lit lit(room);
        const auto got = meanLuminance(lit, *lit.estimator("irradiance_cache"), {1, 1.5F, 1.3F}, 1);
        const auto expected = meanLuminance(lit, *lit.estimator("path"), {1, 1.5F, 1.3F}, 2);
        EXPECT_LT(expected.standardError, 0.02 * expected.value);
        EXPECT_NEAR(got.value, expected.value, 5 * std::hypot(got.standardError, expected.standardError) + 0.02 * expected.value);
    }
}

TEST(IrradianceCache, HasTheLightOfPathsInARichRoom) {
    const Lit lit(richRoom());
    expectLightOfPaths(lit, sensorsIn(Box3({0, 0, 0}, {4, 3, 2.5F})));
}

}  // namespace
}  // namespace luxdeck::test
