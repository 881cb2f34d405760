// Next-event estimation against integrals that know nothing of it: rays over a cone of directions, and Lambert's
// contour formula.
#include "engine/sampling/light_sampler.h"

#include "engine/core/statistics.h"
#include "engine/sampling/sobol.h"
#include "engine/sampling/warp.h"
#include "tests/support/openings.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace luxdeck::test {
namespace {

/// A table with light to all sides, more of it downwards.
CandelaTable broadTable() {
    return axialTable([](double v) { return 500 + 300 * std::cos(v * kDegree); });
}

Scene oneLuminaire(OpeningShape shape, double scale = 1) {
    SceneBuilder b;
    return b.luminaire({0.5F, 0.2F, 2.5F}, broadTable(), openingOf(shape, scale), {0.2F, 0.3F, -1}).build();
}

PlacedOpening openingIn(const Scene& scene, std::size_t i = 0) {
    const auto& l = scene.luminaires[i];
    return PlacedOpening::of(l, scene.luminaireTypes[l.type].photometry.opening);
}

/// The integral of f over the directions of a cone about the opening, by side x side midpoints: its solid
/// angle is divided evenly, borders of the opening are off by a part of a cell.
double overCone(const PlacedOpening& opening, const Receiver& at, int side, const std::function<double(const Vec3&, const Vec2&)>& f) {
    const Vec3 axis = opening.centre - at.position;
    const float sine = std::min(1.02F * opening.halfM.length() / axis.length(), 1.0F), least = std::sqrt(1 - sine * sine);
    const Frame frame = Frame::about(axis.normalized());
    double sum = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Vec2 u{(static_cast<float>(x) + 0.5F) / static_cast<float>(side), (static_cast<float>(y) + 0.5F) / static_cast<float>(side)};
            const float z = 1 - u.x * (1 - least), r = std::sqrt(std::max(0.0F, 1 - z * z)), phi = 2 * kPi * u.y;
            sum += f(frame.toWorld({r * std::cos(phi), r * std::sin(phi), z}), u);
        }
    return sum * 2 * kPiD * (1 - least) / (double{1.0} * side * side);
}

bool emitsTowards(const PlacedOpening& opening, const PlacedOpening::Meeting& met, const Vec3& direction) {
    return opening.flat() || dot(met.normal, direction) < 0;
}

/// Illuminance by rays alone.
double luxByRays(const LightSampler& lights, const PlacedOpening& opening, const Receiver& at) {
    return overCone(opening, at, 1000, [&](const Vec3& d, const Vec2&) {
        const auto met = opening.intersect(at.position, d, 0, kInfinity);
        const float cosine = dot(d, at.normal);
        if (!met || cosine <= 0 || !emitsTowards(opening, *met, d)) return 0.0;
        return double{lights.openingRadiance(0, -d).g} * cosine;
    });
}
constexpr double kConeError = 2e-3;  // measured: halving the cells changes the integrals by less than 5e-4

/// Mean and 95 % interval of 16 sets of 4096 samples.
Interval meanOfSets(const std::function<double(SamplePath&)>& f) {
    std::vector<double> means;
    for (std::uint64_t set = 0; set < 16; ++set) {
        double sum = 0;
        for (std::uint32_t i = 0; i < 4096; ++i) {
            SamplePath path(streamSeed(5, set), i);
            sum += f(path);
        }
        means.push_back(sum / 4096);
    }
    return meanOfReplicates(means);
}

double luxBySamples(const LightSample& s, const Receiver& at) { return double{s.weight.g} * std::max(0.0F, dot(s.direction, at.normal)); }

LightSample draw(const LightSampler& lights, const Receiver& at, SamplePath& path) {
    const float select = path.next1D();
    return lights.sample(at, select, path.next2D());
}

class OpeningLight : public testing::TestWithParam<OpeningShape> {};

std::vector<Receiver> receivers() {
    return {{{0, 0, 0}, {0, 0, 1}}, {{2, -1, 1}, Vec3(-1, 0.3F, 0.5F).normalized()}, {{0.4F, 0.9F, 1.6F}, {0, 0, 1}, true}};
}

// 2 is the ratio of 4 standard errors to a 95 % half-width.
TEST_P(OpeningLight, MeanWeightIsTheIlluminance) {
    const Lit lit(oneLuminaire(GetParam()));
    for (const auto& at : receivers()) {
        const auto mean = meanOfSets([&](SamplePath& path) { return luxBySamples(draw(*lit.lights, at, path), at); });
        const double expected = luxByRays(*lit.lights, openingIn(lit.scene), at);
        EXPECT_NEAR(mean.value, expected, 2 * mean.ci95 + kConeError * expected) << at.position;
    }
}

// The samples of a part of the opening, each worth 1 / pdf, add up to the solid angle of that part. (The density
// itself has poles at the rim of a round body, where its integral converges badly.) 64 parts of the cone, 5 standard
// errors each: false alarm 4e-5; and 5e-5 of the cone for the midpoints.
TEST_P(OpeningLight, DensityIsThatOfTheSamples) {
    const Lit lit(oneLuminaire(GetParam()));
    const auto opening = openingIn(lit.scene);
    for (auto at : receivers()) {
        at.glossy = true;  // every light is shared
        constexpr int kBins = 8, kCount = 1 << 15;
        std::vector<double> angles(kBins * kBins);
        std::vector<MeanVariance> found(kBins * kBins);
        const auto bin = [](const Vec2& u) {
            const auto cell = [](float w) { return static_cast<std::size_t>(std::clamp(static_cast<int>(w * kBins), 0, kBins - 1)); };
            return cell(u.x) * kBins + cell(u.y);
        };
        double chance = 0, cells = 0;
        const double seen = overCone(opening, at, 1024, [&](const Vec3& d, const Vec2& u) {
            const double pdf = lit.lights->pdfOpening(at, 0, d);
            chance += pdf, cells += pdf > 0 ? 1 : 0;
            angles[bin(u)] += pdf > 0 ? 1 : 0;
            return pdf > 0 ? 1.0 : 0.0;
        });
        const double cell = seen / cells;
        if (opening.flat() || GetParam() == OpeningShape::Box) { EXPECT_LE(chance * cell, 1 + kConeError); }

        const Frame frame = Frame::about((opening.centre - at.position).normalized());
        const float sine = std::min(1.02F * opening.halfM.length() / (opening.centre - at.position).length(), 1.0F);
        const float least = std::sqrt(1 - sine * sine);
        RandomStream random(6);
        for (int i = 0; i < kCount; ++i) {
            const auto number = [&] { return static_cast<float>(random.uniform() * 0.9999999); };
            const float select = number(), x = number();
            const auto s = lit.lights->sample(at, select, {x, number()});
            std::size_t mine = found.size();
            if (s.lit()) {
                ASSERT_TRUE(s.shared);
                const Vec3 d = frame.toLocal(s.direction);
                const float phi = std::atan2(d.y, d.x) / (2 * kPi);
                mine = bin({(1 - d.z) / (1 - least), phi < 0 ? phi + 1 : phi});
            }
            for (std::size_t b = 0; b < found.size(); ++b) found[b].add(b == mine ? 1 / double{s.pdfSolidAngle} : 0);
        }
        for (std::size_t b = 0; b < found.size(); ++b)
            EXPECT_NEAR(found[b].mean(), angles[b] * cell, 5 * std::sqrt(found[b].meanVariance()) + 5e-5 * cell * 1024 * 1024)
                << "part " << b << " from " << at.position;
    }
}

TEST_P(OpeningLight, SharesItWithTheReceiversDirectionsExactlyWhenBothSaySo) {
    const Lit lit(oneLuminaire(GetParam(), 0.8));
    RandomStream random(7);
    int shared = 0, own = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 p{static_cast<float>(random.normal()), static_cast<float>(random.normal()), static_cast<float>(random.uniform() * 2)};
        const Receiver at{p, {0, 0, 1}, i % 4 == 0};
        const auto s = lit.lights->sample(at, 0.5F, {static_cast<float>(random.uniform()), 0.4F});
        if (!s.lit()) continue;
        const float pdf = lit.lights->pdfOpening(at, 0, s.direction);
        const auto met = openingIn(lit.scene).intersect(at.position, s.direction, 0, kInfinity);
        if (!met || std::abs(dot(met->normal, s.direction)) < 0.05F) continue;  // grazing: rounding decides the cosine
        if (s.shared && pdf > 0) {
            // The distance and cosine found again by the ray: 1e-6 m over the cosine squared, at 0.3 m or more.
            EXPECT_NEAR(pdf / s.pdfSolidAngle, 1, 0.02);
            ++shared;
        } else if (!s.shared) {
            EXPECT_EQ(pdf, kInfinity);
            ++own;
        }
    }
    EXPECT_GT(shared, 500);
    EXPECT_GT(own, 500);
}

// Near the light both strategies look for it: weighed by the balance heuristic they make the whole, no more.
TEST_P(OpeningLight, BothStrategiesTogetherMakeTheWhole) {
    const Lit lit(oneLuminaire(GetParam()));
    const auto opening = openingIn(lit.scene);
    for (const auto& at : {Receiver{{0.4F, 0.9F, 1.6F}, {0, 0, 1}}, Receiver{{0, 0, 0}, {0, 0, 1}}}) {
        const Frame frame = Frame::about(at.normal);
        const auto mean = meanOfSets([&](SamplePath& path) {
            const auto s = draw(*lit.lights, at, path);
            double lux = luxBySamples(s, at);
            if (s.shared) lux *= s.pdfSolidAngle / (s.pdfSolidAngle + std::max(0.0F, dot(s.direction, at.normal)) / kPi);
            const Vec3 local = cosineHemisphere(path.next2D()), d = frame.toWorld(local);
            if (const auto met = opening.intersect(at.position, d, 0, kInfinity); met && emitsTowards(opening, *met, d)) {
                const float own = local.z / kPi;
                lux += kPiD * lit.lights->openingRadiance(0, -d).g * own / (own + lit.lights->pdfOpening(at, 0, d));
            }
            return lux;
        });
        const double expected = luxByRays(*lit.lights, opening, at);
        EXPECT_NEAR(mean.value, expected, 2 * mean.ci95 + kConeError * expected) << at.position;
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, OpeningLight, testing::ValuesIn(kExtendedShapes), [](const auto& shape) { return shapeName(shape.param); });

TEST(LightSampler, APointGivesTheInverseSquareLaw) {
    SceneBuilder b;
    const Lit lit(b.isotropic({0, 0, 2}, 4 * kPiD * 100).build());
    const auto s = lit.lights->sample({{0, 0, 0}, {0, 0, 1}}, 0.3F, {0.1F, 0.9F});
    EXPECT_NEAR(s.weight.g, 25, 25e-6);  // float rounding of I / d^2 = 100 / 4
    EXPECT_EQ(s.pdfSolidAngle, 0);
    EXPECT_FALSE(s.shared);
    EXPECT_EQ(s.distance, 2);
}

// Bug: an opening whose file gives no light anywhere was met by rays, and the light sampler, which has no light for it, was
// asked for its place beyond the end of its list. Invariant: what gives no light is not there to be met.
TEST(LightSampler, AnOpeningThatIsDarkByItsFileIsNotMet) {
    SceneBuilder b;
    b.luminaire({0, 0, 2}, axialTable([](double) { return 0.0; }), openingOf(OpeningShape::Rectangle), {0, 0, -1});
    b.luminaire({5, 0, 2}, broadTable(), openingOf(OpeningShape::Rectangle), {0, 0, -1});
    auto scene = b.build();
    for (const bool bruteForce : {false, true}) {
        const Lit lit(scene, bruteForce);
        std::vector<Ray> rays(2);
        for (auto& ray : rays) ray.direction = {0, 0, 1};
        rays[0].origin = {0, 0, 0}, rays[1].origin = {5, 0, 0};
        std::vector<Hit> hits(2);
        lit.raycaster->closestHits(rays, hits, Targets::Everything);
        EXPECT_EQ(hits[0].distance, kInfinity);
        EXPECT_NEAR(hits[1].distance, 2 - kFlushM, 1e-6);  // float rounding
    }
}

}  // namespace
}  // namespace luxdeck::test
