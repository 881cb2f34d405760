#include "engine/scene/opening.h"

#include "engine/core/rng.h"
#include "tests/support/chi_square.h"
#include "tests/support/openings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace luxdeck::test {
namespace {

class Opening : public testing::TestWithParam<OpeningShape> {
protected:
    const PlacedOpening opening = tiltedOpening(GetParam());
    const Vec3 half = opening.halfM;
    [[nodiscard]] Vec3 local(const Vec3& world) const { return opening.frame.toLocal(world - opening.centre); }
    [[nodiscard]] static Vec2 random(RandomStream& stream) {
        const auto x = static_cast<float>(stream.uniform());
        return {std::min(x, 0x1.fffffep-1F), std::min(static_cast<float>(stream.uniform()), 0x1.fffffep-1F)};
    }
};

/// The bin of a point of the surface: 16 x 16 cells of equal area on each of its faces, and all faces' areas.
struct Cell {
    std::size_t face;
    float s, t;  // 0..1, area preserving
};

float turn(float x, float y) { return std::atan2(y, x) / (2 * kPi) + 0.5F; }

Cell cellOf(OpeningShape shape, const Vec3& h, const Vec3& p, const Vec3& normal) {
    const auto along = [&](int axis) { return 0.5F + 0.5F * p[axis] / h[axis]; };
    switch (shape) {
        case OpeningShape::Rectangle: return {0, along(0), along(1)};
        case OpeningShape::Disc: return {0, (p.x * p.x + p.y * p.y) / (h.x * h.x), turn(p.x, p.y)};
        case OpeningShape::Sphere: return {0, along(2), turn(p.x, p.y)};
        case OpeningShape::Cylinder:
            if (std::abs(normal.z) < 0.5F) return {0, along(2), turn(p.x, p.y)};
            return {normal.z < 0 ? 1U : 2U, (p.x * p.x + p.y * p.y) / (h.x * h.x), turn(p.x, p.y)};
        default: break;
    }
    int axis = 0;
    while (std::abs(normal[axis]) < 0.5F) ++axis;
    return {static_cast<std::size_t>(2 * axis) + (normal[axis] > 0 ? 1U : 0U), along((axis + 1) % 3), along((axis + 2) % 3)};
}

std::vector<double> faceAreas(OpeningShape shape, const Vec3& h) {
    if (shape == OpeningShape::Cylinder) {
        const double cap = kPiD * h.x * h.x;
        return {4 * kPiD * h.x * h.z, cap, cap};
    }
    if (shape != OpeningShape::Box) return {1};
    const double x = 4.0 * h.y * h.z, y = 4.0 * h.x * h.z, z = 4.0 * h.x * h.y;
    return {x, x, y, y, z, z};
}

// z < 4 of chi^2: false alarm 3e-5 a shape.
TEST_P(Opening, PointsAreUniformByArea) {
    constexpr int kSide = 16, kCount = 1 << 17;
    const auto areas = faceAreas(GetParam(), half);
    double total = 0;
    for (const double a : areas) total += a;
    std::vector<double> counts(areas.size() * kSide * kSide), expected;
    for (const double a : areas) expected.insert(expected.end(), kSide * kSide, kCount * a / total / (kSide * kSide));
    RandomStream stream(1);
    for (int i = 0; i < kCount; ++i) {
        const auto point = opening.samplePoint(random(stream));
        const auto cell = cellOf(GetParam(), half, local(point.position), opening.frame.toLocal(point.normal));
        const auto bin = [](float w) { return static_cast<std::size_t>(std::clamp(static_cast<int>(w * kSide), 0, kSide - 1)); };
        ++counts[(cell.face * kSide + bin(cell.s)) * kSide + bin(cell.t)];
    }
    EXPECT_LT(chiSquareZ(counts, expected), 4);
}

// Positions are floats near 5 m: spacing 5e-7 m, a handful of roundings.
constexpr float kRounding = 4e-6F;

TEST_P(Opening, PointsAndNormalsLieOnTheSurfaceWithinTheBounds) {
    RandomStream stream(2);
    auto bounds = opening.bounds();
    bounds.min -= Vec3(kRounding), bounds.max += Vec3(kRounding);
    for (int i = 0; i < 5000; ++i) {
        const auto point = opening.samplePoint(random(stream));
        ASSERT_TRUE(bounds.intersects(point.position));
        ASSERT_NEAR(point.normal.length(), 1, 1e-5F);
        ASSERT_EQ(point.twoSided, opening.flat());
        // From just outside, straight back: the surface is there, and faces back.
        const auto met = opening.intersect(point.position + point.normal, -point.normal, 0, kInfinity);
        ASSERT_TRUE(met);
        ASSERT_NEAR(met->distance, 1, 10 * kRounding);
        if (!opening.flat()) { ASSERT_GT(dot(met->normal, point.normal), 0.5F); }
    }
}

TEST_P(Opening, RaysMeetThePointsTheyAreAimedAt) {
    RandomStream stream(3);
    int nearSide = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto point = opening.samplePoint(random(stream));
        const Vec3 origin = opening.centre + Vec3(static_cast<float>(stream.normal()), static_cast<float>(stream.normal()), static_cast<float>(stream.normal())).normalized() * 3.0F;
        const Vec3 towards = point.position - origin;
        const float distance = towards.length();
        const Vec3 direction = towards / distance;
        if (std::abs(dot(point.normal, direction)) < 0.02F) continue;  // grazing: rounding decides what is met
        const Vec3 p = local(point.position);
        if (GetParam() == OpeningShape::Rectangle && std::max(std::abs(p.x) / half.x, std::abs(p.y) / half.y) > 0.999F) continue;
        if (GetParam() == OpeningShape::Disc && p.length() > 0.999F * half.x) continue;  // rounding may miss the rim
        const auto met = opening.intersect(origin, direction, 0, kInfinity);
        ASSERT_TRUE(met);
        // A position error of e shifts the distance by e over the cosine, here at least 0.02.
        const float slack = kRounding / 0.02F;
        if (point.twoSided || dot(point.normal, direction) < 0) {
            ASSERT_NEAR(met->distance, distance, slack);
            ++nearSide;
        } else {
            ASSERT_LT(met->distance, distance + slack);
            if (distance - met->distance < 4 * slack) continue;  // it only cuts an edge: way in and way out are one
            const auto far = opening.intersect(origin, direction, distance - slack, kInfinity);
            ASSERT_TRUE(far) << "the way out";
            ASSERT_GT(dot(far->normal, direction), 0);
            ASSERT_FALSE(opening.intersect(origin, direction, distance + slack, kInfinity));
        }
        ASSERT_FALSE(opening.intersect(origin, direction, 0, 0.99999F * met->distance)) << "tMax is respected";
        ASSERT_FALSE(opening.intersect(origin, -direction, 0, kInfinity)) << "behind";
    }
    EXPECT_GT(nearSide, 5000);
}

/// Uniform over the sphere: a Fibonacci lattice, good to 1e-4 of a mean of |cosines| at 20 000 directions.
std::vector<Vec3> fibonacci(int n) {
    std::vector<Vec3> out;
    for (int i = 0; i < n; ++i) {
        const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z), phi = i * kPiD * (3 - std::sqrt(5.0));
        out.emplace_back(static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)), static_cast<float>(z));
    }
    return out;
}

// Cauchy: the mean projected area of a convex body is a quarter of its surface; a flat one has two sides.
TEST_P(Opening, MeanProjectedAreaIsAQuarterOfTheSurface) {
    double sum = 0;
    const auto directions = fibonacci(20'000);
    for (const auto& d : directions) sum += opening.projectedAreaM2(d);
    const double surface = opening.areaM2() * (opening.flat() ? 2.0 : 1.0);
    EXPECT_NEAR(sum / 20'000 / (surface / 4), 1, 2e-4);
}

// The part of parallel rays through a square that meets the opening, times the square's area.
TEST_P(Opening, ProjectedAreaIsWhatRaysSee) {
    RandomStream stream(4);
    for (const auto& d : fibonacci(20)) {
        const Frame across = Frame::about(d);
        const float side = 2 * half.length();
        constexpr int kRays = 20'000;
        int hits = 0;
        for (int i = 0; i < kRays; ++i) {
            const Vec2 u = random(stream);
            const Vec3 start = across.toWorld({(u.x - 0.5F) * side, (u.y - 0.5F) * side, -5});
            hits += opening.intersect(opening.centre + opening.frame.toWorld(start), opening.frame.toWorld(d), 0, kInfinity) ? 1 : 0;
        }
        const double p = opening.projectedAreaM2(d) / (double{side} * side), deviation = std::sqrt(p * (1 - p) / kRays);
        EXPECT_NEAR(double{1.0} * hits / kRays, p, 4 * deviation) << d;  // binomial, 4 sd: false alarm 6e-5
    }
}

TEST_P(Opening, LuminanceStaysFiniteAtGrazingAngles) {
    for (const Vec3& d : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.6F, 0.8F, 0), Vec3(0, 0, 1), Vec3(0.6F, 0.8F, 1e-9F)})
        EXPECT_GE(opening.projectedAreaM2(d), (opening.flat() ? 0.999e-3F : 0.1F) * opening.areaM2() * 0.5F) << d;
    if (opening.flat()) { EXPECT_FLOAT_EQ(opening.projectedAreaM2({1, 0, 0}), 1e-3F * opening.areaM2()); }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Opening, testing::ValuesIn(kExtendedShapes), [](const auto& shape) { return shapeName(shape.param); });

TEST(Openings, FlatOnesHangJustBelowTheirCentre) {
    Luminaire l;
    l.position = {1, 2, 3};
    const auto flat = PlacedOpening::of(l, {OpeningShape::Rectangle, 0.6, 0.6, 0});
    EXPECT_EQ(flat.centre, Vec3(1, 2, 3 - kFlushM));
    EXPECT_EQ(PlacedOpening::of(l, {OpeningShape::Box, 0.6, 0.6, 0.1}).centre, l.position);
}

TEST(Openings, APointHasNoSurface) {
    Luminaire l;
    const auto point = PlacedOpening::of(l, {});
    EXPECT_EQ(point.areaM2(), 0);
    EXPECT_EQ(point.samplePoint({0.3F, 0.7F}).position, l.position);
    EXPECT_FALSE(point.intersect({0, 0, -1}, {0, 0, 1}, 0, kInfinity));
}

}  // namespace
}  // namespace luxdeck::test
