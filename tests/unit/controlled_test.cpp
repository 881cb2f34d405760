// A cached field as the control variate: any field, however wrong, leaves the mean and costs little.
#include "engine/transport/control/controlled_estimator.h"

#include "analysis/grids/measurement.h"
#include "engine/core/parallel.h"
#include "engine/transport/radiosity/radiosity_field.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <string>

namespace luxdeck::test {
namespace {

/// Of about 250 comparisons in this file one such deviation is expected in 1,000 runs of other seeds: 4.5 sigma of
/// Student's t with 31 degrees of freedom has the two-sided probability 9e-5, in both estimates together far less.
constexpr double kSigmas = 4.5;

/// A field by a formula.
class Formula final : public IrradianceField {
public:
    explicit Formula(std::function<Rgb(const FieldPoint&)> lux) : lux_(std::move(lux)) {}
    void indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const override {
        for (std::size_t i = 0; i < points.size(); ++i) lux[i] = lux_(points[i]);
    }

private:
    std::function<Rgb(const FieldPoint&)> lux_;
};

std::shared_ptr<const IrradianceField> formula(std::function<Rgb(const FieldPoint&)> lux) { return std::make_shared<Formula>(std::move(lux)); }

struct NamedField {
    std::string name;
    std::shared_ptr<const IrradianceField> field;
};

/// A good one, and those that know nothing or lie.
std::vector<NamedField> fields(const Lit& lit) {
    AlgorithmSettings coarse;
    coarse.effort = 0.05;
    const std::shared_ptr<const IrradianceField> good = RadiosityField::create(lit.transport(), coarse).value();
    const auto times = [good](float factor) {
        return formula([good, factor](const FieldPoint& p) {
            Rgb lux;
            good->indirect({&p, 1}, {&lux, 1});
            return lux * factor;
        });
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    return {{"radiosity", good},
            {"zero", formula([](const FieldPoint&) { return Rgb{}; })},
            {"constant", formula([](const FieldPoint&) { return Rgb(12345.0F); })},
            {"ten times too bright", times(10)},
            {"negative", times(-1)},
            {"only far spikes", formula([](const FieldPoint& p) { return Rgb(p.position.x > 5.5F ? 1e6F : 0.0F); })},
            {"not a number in half the room", formula([nan](const FieldPoint& p) { return Rgb(p.position.y > 2 ? nan : 50.0F); })},
            {"infinite", formula([](const FieldPoint&) { return Rgb(std::numeric_limits<float>::infinity()); })}};
}

std::vector<Target> sensors(const Lit& lit, int nx, int ny, SensorKind kind = SensorKind::Planar) {
    const auto box = lit.scene.bounds();
    std::vector<Target> targets;
    for (int i = 0; i < nx * ny; ++i) {
        const auto part = [](int k, int n) { return (0.5F + static_cast<float>(k)) / static_cast<float>(n); };
        Target t;
        t.sensor = {box.min + box.size() * Vec3(part(i % nx, nx), part(i / nx, ny), 0.3F), {0, 0, 1}, kind, {}};
        t.stream = targets.size();
        targets.push_back(t);
    }
    return targets;
}

struct Outcome {
    std::vector<PointSums> points;
    TransportCounters counters;

    [[nodiscard]] double variance() const {
        double sum = 0;
        for (const auto& p : points) {
            MeanVariance mv;
            for (const double m : p.totalMeans()) mv.add(m);
            sum += mv.meanVariance();
        }
        return sum;
    }
};

Outcome ask(const Lit& lit, const RadianceEstimator& estimator, const std::vector<Target>& targets, std::uint32_t perReplicate, std::uint64_t seed = 1) {
    std::vector<std::size_t> members(targets.size());
    std::iota(members.begin(), members.end(), std::size_t{0});
    Outcome out;
    const std::vector<std::uint32_t> firsts(members.size(), 0);
    out.points = measureTogether(estimator, lit.scene.weights, targets, members, seed, firsts, perReplicate, out.counters);
    return out;
}

double standardError(const PointSums& sums) {
    MeanVariance mv;
    for (const double m : sums.totalMeans()) mv.add(m);
    return std::sqrt(mv.meanVariance());
}

void expectSame(const Outcome& a, const Outcome& b, const std::string& what) {
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        const double sigma = std::hypot(standardError(a.points[i]), standardError(b.points[i])), value = b.points[i].total().value;
        EXPECT_NEAR(a.points[i].total().value, value, kSigmas * sigma + 1e-5 * value) << what << ", sensor " << i;
    }
}

std::unique_ptr<RadianceEstimator> controlled(const Lit& lit, std::shared_ptr<const IrradianceField> field) {
    return makeControlledEstimator(lit.transport(), {}, std::move(field)).value();
}

// Invariant: the field changes the noise, never the mean, point by point, and no sample is lost to it.
TEST(Controlled, HasTheMeanThatPathsHaveWhateverTheField) {
    const Lit lit(furnishedRoom());
    for (const auto kind : {SensorKind::Planar, SensorKind::Cylindrical}) {
        const auto targets = sensors(lit, 4, 3, kind);
        const auto path = ask(lit, *lit.estimator("path"), targets, 256, 2);
        for (const auto& [name, field] : fields(lit)) {
            const auto got = ask(lit, *controlled(lit, field), targets, 128);
            expectSame(got, path, name);
            EXPECT_EQ(got.counters.rejected, 0U) << name;
        }
    }
}

TEST(Controlled, HasTheMeanThatPathsHaveInARichRoom) {
    const Lit lit(richRoom());
    const auto targets = sensors(lit, 3, 3);
    expectSame(ask(lit, *lit.estimator("controlled"), targets, 512), ask(lit, *lit.estimator("path"), targets, 1024, 2), "rich room");
}

// Invariant: for a useless field variance times rays is that of a field of zero, and that no worse than `path` by more
// than 10 %. Where all is weighed by the pilot's least squares a field can cost nothing in the mean; 15 % allow for the
// weight's own error (some percent) and that of the variances (ratio of two sums over 12 points of 32 replicates with
// common random numbers: 5 %).
TEST(Controlled, CostsLittleWhenTheFieldIsUseless) {
    const Lit lit(furnishedRoom());
    const auto targets = sensors(lit, 4, 3);
    const auto price = [](const Outcome& o) { return o.variance() * static_cast<double>(o.counters.rays); };
    const auto all = fields(lit);
    const double none = price(ask(lit, *controlled(lit, all[1].field), targets, 256));
    EXPECT_LT(none, 1.1 * price(ask(lit, *lit.estimator("path"), targets, 256)));
    for (const auto& [name, field] : all) EXPECT_LT(price(ask(lit, *controlled(lit, field), targets, 256)), 1.15 * none) << name;
}

// The weight that least squares give: what multiplies the field divides the weight. One path's noise on 2,000 places
// makes 10 % of the weight (3 sigma), the same in both where the field is a multiple.
TEST(Controlled, WeighsTheFieldByWhatItIsWorth) {
    const Lit lit(cubeRoom(0.5F, 1000));
    const auto all = fields(lit);
    const auto weight = [&](std::size_t i) { return controlWeight(lit.transport(), {}, *all[i].field); };
    EXPECT_NEAR(weight(0), 1, 0.1);
    EXPECT_NEAR(weight(3), weight(0) / 10, 1e-5);
    EXPECT_EQ(weight(1), 0) << "zero";
    EXPECT_EQ(weight(4), 0) << "negative";
    EXPECT_EQ(weight(7), 0) << "infinite";
}

TEST(Controlled, RefusesNoField) {
    const Lit lit(cubeRoom(0.5F, 1000));
    EXPECT_FALSE(makeControlledEstimator(lit.transport(), {}, nullptr));
}

// Same seed, same bits, whatever the number of threads that prepare it.
TEST(Controlled, IsTheSameOnAnyNumberOfThreads) {
    const Lit lit(furnishedRoom());
    const auto targets = sensors(lit, 4, 2);
    const auto totals = [&](int threads) {
        const ThreadLimit limit(threads);
        std::vector<double> out;
        for (const auto& p : ask(lit, *lit.estimator("controlled"), targets, 8).points) out.push_back(p.total().value);
        return out;
    };
    EXPECT_EQ(totals(1), totals(2));
}

}  // namespace
}  // namespace luxdeck::test
