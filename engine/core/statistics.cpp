#include "engine/core/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace luxdeck {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The three constants of the minimum's interval: docs/decisions/0003-grid-intervals.md says why.
constexpr double kNoiseInflation = 2.0;         // sqrt(n / m) of the m-out-of-n bootstrap, m = n / 4 [-]
constexpr double kCorrection = 0.8;             // part of the estimated bias that is taken back [-]
constexpr double kCorrectionUncertainty = 0.5;  // squared correction's share in the squared half-width [-]

constexpr double kChanceSkewness = 3.0;    // standard errors of a skewness that are taken for chance [-]
constexpr double kDoubtfulSkewness = 5.0;  // the same of the darkest of many points [-]
constexpr double kNormal95 = 1.959963984540054;
constexpr double kReachSigmas = 5.0;   // a normal variate beyond is left out: probability 3e-7
constexpr int kIntegrationSteps = 64;  // over <= 10 sigmas: a step of 0.16, error of the integral below 1e-6
constexpr double kNegligible = 1e-9;   // chance that the smallest lies higher still: the integral ends

double square(double x) { return x * x; }

/// P(|T| < t) for Student's t. With t = sqrt(nu) tan(phi) the density is a power of cos(phi), bounded
/// and smooth however heavy the tail, so Simpson's rule does.
double studentCentralProbability(double t, double nu) {
    constexpr int intervals = 128;
    const double phiMax = std::atan(t / std::sqrt(nu));
    const double step = phiMax / intervals;
    double sum = 1.0 + std::pow(std::cos(phiMax), nu - 1.0);
    for (int i = 1; i < intervals; ++i) {
        sum += (i % 2 == 1 ? 4.0 : 2.0) * std::pow(std::cos(i * step), nu - 1.0);
    }
    const double gammaRatio = std::exp(std::lgamma((nu + 1.0) / 2.0) - std::lgamma(nu / 2.0));
    return 2.0 * gammaRatio / std::sqrt(std::numbers::pi) * sum * step / 3.0;
}

double studentDensity(double t, double nu) {
    const double gammaRatio = std::exp(std::lgamma((nu + 1.0) / 2.0) - std::lgamma(nu / 2.0));
    return gammaRatio / std::sqrt(nu * std::numbers::pi) * std::pow(1.0 + t * t / nu, -(nu + 1.0) / 2.0);
}

/// One point of the grid: the mean of its replicates, that mean's standard error [lx] and third central moment [lx^3].
struct PointEstimate {
    std::size_t index;
    double value;
    double sigma;
    double cubed;
};

/// The third central moment of the mean of R values. Source: the k-statistic k3 of Fisher 1930, over R^2.
double thirdMomentOfMean(std::span<const double> values, double mean) {
    const double n = static_cast<double>(values.size());
    if (n < 3.0) return 0.0;
    double sum = 0;
    for (const double x : values) sum += (x - mean) * (x - mean) * (x - mean);
    return sum / (n * (n - 1.0) * (n - 2.0));
}

double skewnessOf(double cubed, double sigma) { return sigma > 0.0 ? cubed / (sigma * sigma * sigma) : 0.0; }

std::vector<PointEstimate> pointEstimates(std::span<const double> replicates, std::size_t pointCount) {
    const std::size_t replicateCount = replicates.size() / pointCount;
    std::vector<PointEstimate> points;
    points.reserve(pointCount);
    for (std::size_t i = 0; i < pointCount; ++i) {
        MeanVariance statistics;
        const auto own = replicates.subspan(i * replicateCount, replicateCount);
        for (const double x : own) statistics.add(x);
        points.push_back({i, statistics.mean(), std::sqrt(statistics.meanVariance()), thirdMomentOfMean(own, statistics.mean())});
    }
    return points;
}

/// Sum of independent variances and how well it is known. Source: Welch 1947, Satterthwaite 1946.
class PooledVariance {
public:
    void add(double variance) {
        sum_ += variance;
        sumOfSquares_ += variance * variance;
    }
    [[nodiscard]] double sum() const { return sum_; }
    [[nodiscard]] double degreesOfFreedom(double ofOneTerm) const {
        return sumOfSquares_ > 0.0 ? ofOneTerm * sum_ * sum_ / sumOfSquares_ : ofOneTerm;
    }

private:
    double sum_ = 0;
    double sumOfSquares_ = 0;
};

Interval gridMean(std::span<const PointEstimate> points, double dof) {
    const double count = static_cast<double>(points.size());
    double sum = 0, cubed = 0;
    PooledVariance variance;
    for (const PointEstimate& p : points) {
        sum += p.value, cubed += p.cubed;
        variance.add(p.sigma * p.sigma);
    }
    const double sigma = std::sqrt(variance.sum());
    return skewedInterval(sum / count, sigma / count, skewnessOf(cubed, sigma), variance.degreesOfFreedom(dof));
}

/// P(a normal variate > t): a step when it is certain.
double survival(const PointEstimate& p, double t) {
    if (p.sigma <= 0.0) return p.value > t ? 1.0 : 0.0;
    return 0.5 * std::erfc((t - p.value) / p.sigma * (1.0 / std::numbers::sqrt2));
}

/// The smallest of independent normal variates.
struct MinimumOfNormals {
    std::vector<PointEstimate> candidates;  // those that can be the smallest
    std::vector<double> probability;        // #candidates  that it is this one [-]
    double expected = 0;                    // expectation of the smallest
};

/// Exact up to quadrature: the survival function of a minimum is the product of the points' own, so
/// the bootstrap's expectations need no random draws.
MinimumOfNormals minimumOfNormals(std::span<const PointEstimate> points, double inflation) {
    const double reach = kReachSigmas * inflation;
    double low = kInfinity;
    double high = kInfinity;
    for (const PointEstimate& p : points) {
        low = std::min(low, p.value - reach * p.sigma);
        high = std::min(high, p.value + reach * p.sigma);
    }
    MinimumOfNormals result;
    for (const PointEstimate& p : points) {
        if (p.value - reach * p.sigma <= high) {
            result.candidates.push_back({p.index, p.value, p.sigma * inflation, p.cubed});
        }
    }
    const std::size_t count = result.candidates.size();
    result.probability.assign(count, 0.0);
    std::vector<double> above(count, 1.0);  // survival at the lower end of the step
    std::vector<double> aboveNext(count);
    const double step = (high - low) / kIntegrationSteps;
    double allAbove = 1.0;
    result.expected = low;
    for (int k = 1; k <= kIntegrationSteps && allAbove > kNegligible; ++k) {
        const double t = k < kIntegrationSteps ? low + step * k : high;
        double allAboveNext = 1.0;
        for (std::size_t i = 0; i < count; ++i) {
            aboveNext[i] = survival(result.candidates[i], t);
            allAboveNext *= aboveNext[i];
        }
        // Of the probability that the minimum lies in this step, each point owns a share in
        // proportion to its hazard, -d log(survival).
        double hazardSum = 0;
        for (std::size_t i = 0; i < count; ++i) hazardSum += 1.0 - aboveNext[i] / above[i];
        for (std::size_t i = 0; i < count && hazardSum > 0.0; ++i) {
            result.probability[i] += (allAbove - allAboveNext) * (1.0 - aboveNext[i] / above[i]) / hazardSum;
        }
        result.expected += 0.5 * step * (allAbove + allAboveNext);
        allAbove = allAboveNext;
        above.swap(aboveNext);
    }
    return result;
}

struct MinimumEstimate {
    Interval interval;
    Interval noise;     // the same without the correction's share
    std::size_t point;  // most likely to be the darkest
};

MinimumEstimate gridMinimum(std::span<const PointEstimate> points, double dof) {
    const MinimumOfNormals bootstrap = minimumOfNormals(points, kNoiseInflation);
    double smallest = kInfinity;
    for (const PointEstimate& p : points) smallest = std::min(smallest, p.value);
    // Noise `kNoiseInflation` times as large lowers the smallest value that many times as far.
    const double bias = points.size() > 1 ? std::max(smallest - bootstrap.expected, 0.0) / kNoiseInflation : 0.0;
    const double correction = kCorrection * bias;

    PooledVariance variance;  // of "the darkest point", each counted as often as it is that
    double cubed = 0;
    std::size_t best = 0;
    for (std::size_t i = 0; i < bootstrap.candidates.size(); ++i) {
        const double sigma = bootstrap.candidates[i].sigma / kNoiseInflation;
        variance.add(bootstrap.probability[i] * sigma * sigma);
        cubed += bootstrap.probability[i] * bootstrap.candidates[i].cubed;
        if (bootstrap.probability[i] > bootstrap.probability[best]) best = i;
    }
    const double sigma = std::sqrt(variance.sum()), value = smallest + correction;
    // Of one point's replicates, whichever point it is: pooling does not make a skewness better known. Of many points the
    // darkest is chosen by its noise, and the correction's constants hold for Student's interval: only a skewness beyond
    // any doubt counts.
    const double skewness = skewnessOf(cubed, sigma), byChance = kDoubtfulSkewness * std::sqrt(6.0) / (dof + 1.0);
    const auto noise = skewedInterval(value, sigma, std::abs(skewness) < byChance ? 0.0 : skewness, variance.degreesOfFreedom(dof));
    const auto with = [&](double side) { return std::sqrt(square(side) + kCorrectionUncertainty * square(correction)); };
    return {Interval::sides(value, with(noise.below()), with(noise.above())), noise, bootstrap.candidates[best].index};
}

/// First-order error of a ratio. The darkest point is also one of the mean's N terms, so their
/// covariance is that point's variance / N; with N = 1 the ratio is 1 without any error.
Interval gridUniformity(const MinimumEstimate& minimum, const Interval& mean, std::size_t pointCount) {
    if (mean.value == 0.0) return {0.0, kInfinity};
    if (pointCount == 1) return {minimum.interval.value / mean.value, 0.0};
    const double ratio = minimum.interval.value / mean.value;
    const auto side = [&](double ofMinimum, double ofMean, double noise) {
        const double shared = square(noise) / static_cast<double>(pointCount);
        const double squared = square(ofMinimum) + square(ratio * ofMean) - 2.0 * ratio * shared;
        return std::sqrt(std::max(squared, 0.0)) / std::abs(mean.value);
    };
    return Interval::sides(ratio, side(minimum.interval.below(), mean.above(), minimum.noise.below()),
                           side(minimum.interval.above(), mean.below(), minimum.noise.above()));
}

}  // namespace

Interval Interval::sides(double value, double below, double above) {
    Interval out{value, std::max(below, above)};
    if (below != above) out.narrower = std::min(below, above), out.narrowBelow = below < above;
    return out;
}

double Interval::relative() const {
    if (ci95 == 0.0) return 0.0;
    return value == 0.0 ? kInfinity : ci95 / std::abs(value);
}

double studentT95(double degreesOfFreedom) {
    assert(degreesOfFreedom >= 1.0);
    const double nu = degreesOfFreedom;
    if (nu > 1e4) {  // Cornish-Fisher; the next term is below 3e-8
        const double z = kNormal95;
        return z + (z * z * z + z) / (4.0 * nu);
    }
    // The probability is concave in t, so Newton's steps from the left never pass the root.
    double t = kNormal95;
    for (int i = 0; i < 60; ++i) {
        const double step = (0.95 - studentCentralProbability(t, nu)) / (2.0 * studentDensity(t, nu));
        t += step;
        if (std::abs(step) < 1e-9 * t) break;
    }
    return t;
}

Interval skewedInterval(double value, double sigma, double skewness, double degreesOfFreedom) {
    if (sigma == 0.0) return {value, 0.0};
    const double t = studentT95(degreesOfFreedom);
    // What normal replicates show by chance is no skewness: its standard error is sqrt(6 / R) of one, over sqrt(R) of the mean.
    const double byChance = kChanceSkewness * std::sqrt(6.0) / (degreesOfFreedom + 1.0);
    if (std::abs(skewness) < byChance) return {value, t * sigma};
    // The studentised mean T has the mean's skewness with the other sign, twice; T + s T^2 / 3 + s^2 T^3 / 27 + s / 6 is
    // normal up to order 1 / n. Its inverse at -t and t bounds T.
    const auto inverse = [&](double y) { return (std::cbrt(1.0 + skewness * (y - skewness / 6.0)) - 1.0) * 3.0 / skewness; };
    return Interval::sides(value, std::max(inverse(t), 0.0) * sigma, std::max(-inverse(-t), 0.0) * sigma);
}

Interval meanOfReplicates(std::span<const double> replicates) {
    assert(replicates.size() >= 2);
    MeanVariance statistics;
    for (const double x : replicates) statistics.add(x);
    const double sigma = std::sqrt(statistics.meanVariance());
    return skewedInterval(statistics.mean(), sigma, skewnessOf(thirdMomentOfMean(replicates, statistics.mean()), sigma),
                          static_cast<double>(replicates.size() - 1));
}

GridInterval gridInterval(std::span<const double> replicates, std::size_t pointCount) {
    assert(pointCount >= 1 && replicates.size() % pointCount == 0 && replicates.size() / pointCount >= 2);
    const std::vector<PointEstimate> points = pointEstimates(replicates, pointCount);
    const double dof = static_cast<double>(replicates.size() / pointCount - 1);
    const Interval mean = gridMean(points, dof);
    const MinimumEstimate minimum = gridMinimum(points, dof);
    return {mean, minimum.interval, gridUniformity(minimum, mean, pointCount), minimum.point};
}

}  // namespace luxdeck
