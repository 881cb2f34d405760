// Do the 95 % intervals of a grid's mean, minimum and uniformity hold the truth 95 % of the time?
// Each case is one truth, "measured" anew with 2000 seeds. docs/decisions/0003-grid-intervals.md has
// the table that this test prints with LUXDECK_COVERAGE_TRIALS=20000 in the environment.
#include "engine/core/rng.h"
#include "engine/core/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace luxdeck {
namespace {

enum class Noise { Normal, Lognormal };

/// A grid whose truth is known.
struct Truth {
    std::string name;
    std::vector<double> lux;
    double relativeError;         // standard error of a point's mean over its value [-]
    int replicateCount = 16;
    Noise noise = Noise::Lognormal;
    bool ambiguous = false;       // several points can be the darkest: a conservative interval is accepted
    double unevenness = 1.0;      // every second point's error over the others' [-]
};

std::ostream& operator<<(std::ostream& out, const Truth& truth) { return out << truth.name; }

/// `count` candidates spaced by `gap` standard errors from 100 lx upwards, and 60 brighter points.
Truth ladder(std::string name, int count, double gap, int replicateCount = 16) {
    constexpr double relativeError = 0.0125;  // 5 % a replicate at R = 16
    std::vector<double> lux;
    for (int i = 0; i < count; ++i) lux.push_back(100.0 * (1.0 + gap * relativeError * i));
    for (int i = 0; i < 60; ++i) lux.push_back(lux[static_cast<std::size_t>(count - 1)] * 1.3 + 2.0 * i);
    return {std::move(name), std::move(lux), relativeError, replicateCount, Noise::Lognormal, count > 1};
}

/// A room lit from the middle: 500 lx there, half of it in the corners. Off-centre luminaires
/// (`shift`, of half the room's width) leave one corner darkest instead of four.
Truth room(int columns, int rows, double relativeError, double shift) {
    std::vector<double> lux;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const double u = 2.0 * (i + 0.5) / columns - 1.0 - shift;
            const double v = 2.0 * (j + 0.5) / rows - 1.0 - 0.6 * shift;
            lux.push_back(500.0 * (1.0 - 0.25 * (u * u + v * v)));
        }
    }
    const std::string name = "room_" + std::to_string(columns) + "x" + std::to_string(rows) + "_error_" +
                             std::to_string(std::lround(relativeError * 1000)) + "permille_shift_" +
                             std::to_string(std::lround(shift * 100));
    return {name,       std::move(lux), relativeError, 16, relativeError < 0.02 ? Noise::Lognormal : Noise::Normal,
            shift < 0.1};
}

/// The opposite: darkest in the middle, with a flat minimum of which many points take part.
Truth hollow(int columns, int rows, double relativeError) {
    Truth truth = room(columns, rows, relativeError, 0.07);
    for (double& lux : truth.lux) lux = 1000.0 - lux;
    truth.name = "hollow" + truth.name.substr(4);
    truth.ambiguous = true;
    return truth;
}

/// One point `gap` standard errors below 20 equal ones: hardly to be told from 21 ties.
Truth plateau(double gap) {
    Truth truth = ladder("plateau_gap_" + std::to_string(std::lround(gap * 10)), 1, 0);
    std::fill_n(truth.lux.begin() + 1, 20, 100.0 * (1.0 + gap * truth.relativeError));
    truth.ambiguous = true;
    return truth;
}

Truth uneven(Truth truth, double unevenness) {
    truth.name += "_uneven";
    truth.unevenness = unevenness;
    truth.ambiguous = true;
    return truth;
}

std::vector<Truth> truths() {
    std::vector<Truth> all = {
        ladder("unique_R16", 1, 0),     ladder("unique_R32", 1, 0, 32),   ladder("ties_2_R16", 2, 0),
        ladder("ties_2_R32", 2, 0, 32), ladder("ties_4_R16", 4, 0),       ladder("ties_4_R32", 4, 0, 32),
        ladder("ties_16_R16", 16, 0),   ladder("ties_16_R32", 16, 0, 32), ladder("ties_256_R16", 256, 0),
    };
    for (const int count : {2, 4, 16}) {
        for (const double gap : {0.3, 1.0, 2.0, 3.0}) {
            all.push_back(
                ladder("near_" + std::to_string(count) + "_gap_" + std::to_string(std::lround(gap * 10)), count, gap));
        }
    }
    for (const double relativeError : {0.002, 0.01, 0.03}) {
        for (const double shift : {0.0, 0.05, 0.3}) all.push_back(room(6, 8, relativeError, shift));
        all.push_back(hollow(6, 8, relativeError));
    }
    for (const double shift : {0.0, 0.05}) all.push_back(room(20, 20, 0.03, shift));
    all.push_back(hollow(20, 20, 0.01));
    for (const double gap : {1.0, 2.0, 3.0}) all.push_back(plateau(gap));
    all.push_back(uneven(ladder("ties_4", 4, 0), 4.0));
    all.push_back(uneven(room(6, 8, 0.01, 0.05), 4.0));
    all.push_back(uneven(room(6, 8, 0.01, 0.0), 0.25));
    return all;
}

std::vector<double> measure(const Truth& truth, RandomStream& random) {
    const double evenSigma = truth.relativeError * std::sqrt(static_cast<double>(truth.replicateCount));
    std::vector<double> replicates;
    replicates.reserve(truth.lux.size() * static_cast<std::size_t>(truth.replicateCount));
    for (std::size_t i = 0; i < truth.lux.size(); ++i) {
        const double sigma = i % 2 == 0 ? evenSigma : evenSigma * truth.unevenness;
        const double logSigma = std::sqrt(std::log1p(sigma * sigma));  // same mean and variance as the normal case
        for (int r = 0; r < truth.replicateCount; ++r) {
            const double z = random.normal();
            replicates.push_back(truth.lux[i] * (truth.noise == Noise::Normal
                                                     ? 1.0 + sigma * z
                                                     : std::exp(logSigma * z - 0.5 * logSigma * logSigma)));
        }
    }
    return replicates;
}

/// How often an interval held the truth, and how wide it was.
struct Coverage {
    int below = 0;  // interval wholly below the truth
    int above = 0;
    double halfWidth = 0;
    double bias = 0;
    int trials = 0;

    void add(const Interval& interval, double truth) {
        ++trials;
        below += interval.high() < truth ? 1 : 0;
        above += interval.low() > truth ? 1 : 0;
        halfWidth += interval.ci95;
        bias += interval.value - truth;
    }
    [[nodiscard]] double percent() const { return 100.0 - 100.0 * (below + above) / trials; }
};

int trialCount() {
    const char* asked = std::getenv("LUXDECK_COVERAGE_TRIALS");
    return asked != nullptr ? std::max(std::atoi(asked), 1) : 2000;
}

class GridIntervalCoverage : public testing::TestWithParam<Truth> {};

TEST_P(GridIntervalCoverage, HoldsTheTruth) {
    const Truth& truth = GetParam();
    const double minimum = *std::min_element(truth.lux.begin(), truth.lux.end());
    const double mean =
        std::accumulate(truth.lux.begin(), truth.lux.end(), 0.0) / static_cast<double>(truth.lux.size());
    Coverage ofMean, ofMinimum, ofUniformity;
    const int trials = trialCount();
    for (int trial = 0; trial < trials; ++trial) {
        RandomStream random(streamSeed(42, static_cast<std::uint64_t>(trial)));
        const GridInterval found = gridInterval(measure(truth, random), truth.lux.size());
        ofMean.add(found.mean, mean);
        ofMinimum.add(found.minimum, minimum);
        ofUniformity.add(found.uniformity, minimum / mean);
    }
    const double sigma = truth.relativeError * minimum;  // error of the darkest point
    std::printf("| %-32s | %5.1f | %5.1f | %5.1f | %4.1f | %4.1f | %5.2f | %4.2f |\n", truth.name.c_str(),
                ofMean.percent(), ofMinimum.percent(), ofUniformity.percent(), 100.0 * ofMinimum.below / trials,
                100.0 * ofMinimum.above / trials, ofMinimum.bias / trials / sigma,
                ofMinimum.halfWidth / trials / sigma);

    // 93..97 % is what is promised. 2000 trials measure a coverage of 95 % to +-0.49 % (1 sd): with
    // other seeds a case whose true coverage is 95 % would leave the bounds at 4.1 sd (4e-5), the worst
    // one (94.2 %, docs/decisions/0003) at 2.3 sd (1 %). The seeds are fixed, so an alarm repeats.
    constexpr double lowest = 93.0;
    const double highest = truth.ambiguous ? 100.0 : 97.0;
    for (const Coverage* coverage : {&ofMean, &ofMinimum, &ofUniformity}) {
        EXPECT_GE(coverage->percent(), lowest);
        EXPECT_LE(coverage->percent(), coverage == &ofMean ? 97.0 : highest);
    }
    // An interval may not buy its coverage with width: at most 1.3 times that of the least well known
    // point alone (the correction's own share is the rest; 1.23 measured on the flattest hollow).
    const double widest = studentT95(truth.replicateCount - 1) * sigma * std::max(truth.unevenness, 1.0);
    EXPECT_LE(ofMinimum.halfWidth / trials, 1.3 * widest);
}

INSTANTIATE_TEST_SUITE_P(Truths, GridIntervalCoverage, testing::ValuesIn(truths()),
                         [](const auto& instance) { return instance.param.name; });

/// A darkest point and 1 .. 55 others above it, from all but tied (within 0.1 errors) to far away (10).
Truth randomTruth(RandomStream& random) {
    Truth truth = ladder("random", 1, 0);
    truth.lux.resize(1);
    const int count = 1 + static_cast<int>(std::exp(4.0 * random.uniform()));
    const double spread = truth.relativeError * std::exp(4.0 * random.uniform() - 2.0);
    const double shape = 0.3 + 2.0 * random.uniform();
    for (int i = 0; i < count; ++i) {
        truth.lux.push_back(100.0 * (1.0 + spread * std::pow(-std::log(1.0 - random.uniform()), shape)));
    }
    return truth;
}

// The constants were chosen on the truths above; these took no part in it.
TEST(GridInterval, HoldsTheMinimumOfTruthsItWasNotTunedOn) {
    RandomStream random(99);
    Coverage all;
    double lowest = 100.0;
    for (int i = 0; i < 80; ++i) {
        const Truth truth = randomTruth(random);
        Coverage one;
        for (int trial = 0; trial < trialCount() / 20; ++trial) {
            const Interval found = gridInterval(measure(truth, random), truth.lux.size()).minimum;
            one.add(found, truth.lux[0]);
            all.add(found, truth.lux[0]);
        }
        lowest = std::min(lowest, one.percent());
    }
    std::printf("%d trials of 80 random truths: %.1f %%, the lowest of them %.1f %%\n", all.trials, all.percent(),
                lowest);
    // 96.8 % measured with 240,000 trials (and 94.8 % the lowest truth: 100 trials each say nothing
    // about one); 8000 measure it to 0.20 %, so the bounds are 6 sd away (2e-9).
    EXPECT_GE(all.percent(), 95.6);
    EXPECT_LE(all.percent(), 98.0);
}

}  // namespace
}  // namespace luxdeck
