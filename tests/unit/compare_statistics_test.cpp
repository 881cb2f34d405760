#include "analysis/compare/error_statistics.h"
#include "engine/core/rng.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

/// What `compare` says of errors, on synthetic fields whose errors are known. Seeds are fixed; false-alarm rates are those of a
/// fresh seed.
namespace luxdeck {
namespace {

using ::testing::ElementsAre;

constexpr std::size_t kPoints = 200, kParts = 8, kRepetitions = 4;

/// Reference and runs about the truth 100: independent normal noise and a fixed bias at each point, relative.
struct Synthetic {
    double referenceNoise = 0;  // of the parts' mean
    double noise = 0;           // of one repetition
    double bias = 0;            // of alternating sign
    bool together = false;      // all points of a field have the same noise

    [[nodiscard]] RunErrors errors(std::uint64_t seed) const {
        RandomStream random(seed);
        ReferenceFields reference{{}, Field(kPoints, 100.0)};
        for (std::size_t p = 0; p < kParts; ++p) reference.parts.push_back(field(random, referenceNoise * std::sqrt(kParts), 0));
        std::vector<Field> runs;
        for (std::size_t r = 0; r < kRepetitions; ++r) runs.push_back(field(random, noise, bias));
        return runErrors(reference, runs);
    }

private:
    [[nodiscard]] Field field(RandomStream& random, double spread, double offset) const {
        Field out;
        double common = random.normal();
        for (std::size_t i = 0; i < kPoints; ++i) {
            if (!together) common = random.normal();
            out.push_back(100 * (1 + spread * common + (i % 2 == 0 ? offset : -offset)));
        }
        return out;
    }
};

struct Tally {
    MeanVariance meanSquare, biasSquare;
    int covered = 0, biasCovered = 0, biasSeen = 0;
};

Tally tally(const Synthetic& synthetic, int seeds) {
    Tally out;
    const double bias = synthetic.bias * synthetic.bias, square = synthetic.noise * synthetic.noise + bias;
    for (int s = 1; s <= seeds; ++s) {
        const auto e = synthetic.errors(static_cast<std::uint64_t>(s));
        out.meanSquare.add(e.meanSquare.value), out.biasSquare.add(e.biasSquare.value);
        out.covered += e.meanSquare.low() <= square && square <= e.meanSquare.high() ? 1 : 0;
        out.biasCovered += e.biasSquare.low() <= bias && bias <= e.biasSquare.high() ? 1 : 0;
        out.biasSeen += e.bias() ? 1 : 0;
    }
    return out;
}

/// Within 4 standard errors of the mean over 300 seeds: false alarm 6e-5 each.
void expectMean(const MeanVariance& values, double truth) {
    EXPECT_NEAR(values.mean(), truth, 4 * std::sqrt(values.meanVariance()));
}

TEST(CompareStatistics, TheReferencesNoiseIsTakenOut) {
    // The reference is as noisy as the run: without the subtraction the mean square would be twice the truth.
    const auto t = tally({0.02, 0.02, 0, false}, 300);
    expectMean(t.meanSquare, 0.02 * 0.02);
    expectMean(t.biasSquare, 0);
    EXPECT_LT(std::sqrt(t.meanSquare.meanVariance()), 0.05 * 0.02 * 0.02) << "the test could not tell";
}

TEST(CompareStatistics, BiasIsToldFromNoise) {
    const auto t = tally({0.005, 0.02, 0.03, false}, 300);
    expectMean(t.meanSquare, 0.02 * 0.02 + 0.03 * 0.03);
    expectMean(t.biasSquare, 0.03 * 0.03);
    EXPECT_EQ(t.biasSeen, 300);  // 0.03 is 21 standard errors of its square
}

TEST(CompareStatistics, IntervalsCoverWhetherErrorsGoTogetherOrNot) {
    // 95 % asked; of 300 binomial draws fewer than 270 have chance 2e-4. Noise that all points share leaves one value of it
    // for each repetition, a chi square of few degrees, whose interval is known to cover less: half of them must.
    for (const double bias : {0.0, 0.02}) {
        const auto apart = tally({0.005, 0.02, bias, false}, 300);
        EXPECT_GE(apart.covered, 270) << bias;
        EXPECT_GE(apart.biasCovered, 270) << bias;
        const auto together = tally({0.005, 0.02, bias, true}, 300);
        EXPECT_GE(together.covered, 150) << bias;
        EXPECT_GE(together.biasCovered, 150) << bias;
    }
}

TEST(CompareStatistics, NoBiasIsSeenWhereThereIsNone) {
    // One-sided 2.5 %: more than 22 of 300 have chance 1e-5.
    EXPECT_LE(tally({0.005, 0.02, 0, false}, 300).biasSeen, 22);
}

TEST(CompareStatistics, BelowTheReferenceNoErrorIsTold) {
    const auto e = Synthetic{0.02, 0.002, 0, false}.errors(1);
    EXPECT_TRUE(e.belowReference());
    EXPECT_FALSE(e.rms().has_value());
    EXPECT_GE(e.rmsAtMost(), e.reference);
    EXPECT_NEAR(e.reference, 0.02, 0.004);  // 200 variances of 7 degrees: 2 % of its own, five times that
}

TEST(CompareStatistics, LargestAnd99thPercentileOfKnownErrors) {
    ReferenceFields reference{std::vector<Field>(3, Field(100, 10.0)), Field(100, 10.0)};
    Field field;
    for (int i = 1; i <= 100; ++i) field.push_back(10 + 0.01 * i * (i % 2 == 0 ? 1 : -1));
    const auto e = runErrors(reference, std::vector<Field>(3, field));
    EXPECT_NEAR(e.largest, 0.1, 1e-12);
    EXPECT_NEAR(e.percentile99, 0.099, 1e-12);
    EXPECT_NEAR(e.meanSquare.value, 1e-6 * 100 * 101 * 201 / 6 / 100, 1e-12);  // mean of (0.001 i)^2
    EXPECT_NEAR(e.rms()->ci95, 0, 1e-9);                                       // all repetitions agree, the reference is exact
}

std::vector<CurvePoint> power(double exponent, double ci) {
    std::vector<CurvePoint> out;
    for (int i = 0; i < 6; ++i) out.push_back({std::ldexp(0.1, i), 0.2 * std::pow(2.0, exponent * i), ci});
    return out;
}

TEST(CompareStatistics, SlopeOfAPowerLaw) {
    for (const double exponent : {-0.5, -1.0, 0.0}) {
        EXPECT_NEAR(logLogSlope(power(exponent, 0))->value, exponent, 1e-12);
        EXPECT_NEAR(logLogSlope(power(exponent, 0))->ci95, 0, 1e-6);
        EXPECT_NEAR(logLogSlope(power(exponent, 0.1))->value, exponent, 1e-12);
    }
    // Standard error of a slope: sigma / sqrt(sum (x - mean)^2), x = i ln 2 over 6 points: 17.5 (ln 2)^2.
    EXPECT_NEAR(logLogSlope(power(-0.5, 0.1))->ci95, 0.1 / (std::sqrt(17.5) * std::log(2.0)), 1e-9);
    EXPECT_FALSE(logLogSlope(std::vector<CurvePoint>{{1, 0.1, 0}}).has_value());
    EXPECT_FALSE(logLogSlope(std::vector<CurvePoint>{}).has_value());
    EXPECT_FALSE(logLogSlope(std::vector<CurvePoint>{{1, 0.1, 0.1}, {1, 0.2, 0.1}}).has_value()) << "one time alone";
    EXPECT_TRUE(std::isinf(logLogSlope(std::vector<CurvePoint>{{1, 0.2, 0}, {2, 0.1, 0}})->ci95)) << "two exact runs say nothing of their scatter";
}

TEST(CompareStatistics, SlopeIntervalsCover) {
    // 95 % asked at known errors: of 400 fewer than 355 have chance 1e-5.
    int covered = 0;
    for (std::uint64_t s = 1; s <= 400; ++s) {
        RandomStream random(s);
        auto points = power(-0.5, 1.96 * 0.05);
        for (auto& p : points) p.rms *= std::exp(0.05 * random.normal());
        const auto slope = *logLogSlope(points);
        covered += slope.low() <= -0.5 && -0.5 <= slope.high() ? 1 : 0;
    }
    EXPECT_GE(covered, 355);
}

TEST(CompareStatistics, TimeToAnErrorOnAPowerLaw) {
    const auto curve = power(-0.5, 0);  // 0.2 at 0.1 s: error 0.2 sqrt(0.1 / t)
    const auto to = timeToError(curve, 0.1);
    EXPECT_EQ(to.how, Reached::Interpolated);
    EXPECT_NEAR(to.seconds, 0.4, 1e-12);
    EXPECT_NEAR(timeToError(curve, 0.06).seconds, 0.1 * (0.2 / 0.06) * (0.2 / 0.06), 1e-12);
    EXPECT_EQ(timeToError(curve, 0.5).how, Reached::AtOnce);
    EXPECT_EQ(timeToError(curve, 0.5).seconds, 0.1);
    EXPECT_EQ(timeToError(curve, 0.01).how, Reached::NotReached);  // it ends at 0.035
    EXPECT_EQ(timeToError({}, 0.1).how, Reached::NotReached);
}

TEST(CompareStatistics, AnErrorIsReachedWhereTheCurveStaysBelowIt) {
    const std::vector<CurvePoint> curve{{1, 0.08, 0}, {2, 0.12, 0}, {4, 0.06, 0}};
    const auto to = timeToError(curve, 0.1);
    EXPECT_EQ(to.how, Reached::Interpolated);
    EXPECT_GT(to.seconds, 2);
    EXPECT_LT(to.seconds, 4);
}

TEST(CompareStatistics, ErrorAtATimeIsOnTheLine) {
    const auto curve = power(-0.5, 0.1);
    EXPECT_NEAR(errorAt(curve, 0.25).rms, 0.2 * std::sqrt(0.1 / 0.25), 1e-12);
    EXPECT_EQ(errorAt(curve, 0.01).rms, curve.front().rms);
    EXPECT_EQ(errorAt(curve, 100).rms, curve.back().rms);
}

TEST(CompareStatistics, EqualsShareAPlace) {
    const auto of = [](double rms, double ci) { return CurvePoint{1, rms, ci}; };
    EXPECT_THAT(places(std::vector<CurvePoint>{of(0.3, 0.01), of(0.1, 0.01), of(0.105, 0.01), of(0.2, 0.01)}), ElementsAre(4, 1, 1, 3));
    EXPECT_THAT(places(std::vector<CurvePoint>{of(0.1, 0.5), of(0.15, 0.01)}), ElementsAre(1, 1)) << "intervals that overlap";
    EXPECT_THAT(places(std::vector<CurvePoint>{}), ElementsAre());
}

}  // namespace
}  // namespace luxdeck
