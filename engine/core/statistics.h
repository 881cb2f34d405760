#pragma once

#include <cstddef>
#include <span>

namespace luxdeck {

/// A value and the half-width of its 95 % interval, in the value's unit: the larger of its two sides, where they
/// differ. An infinite half-width says that nothing is known yet.
struct Interval {
    double value = 0;
    double ci95 = 0;
    double narrower = -1;      // width of the other side; negative: as wide
    bool narrowBelow = true;   // which side that is

    /// Of two sides, neither negative.
    static Interval sides(double value, double below, double above);
    [[nodiscard]] double below() const { return narrower >= 0 && narrowBelow ? narrower : ci95; }
    [[nodiscard]] double above() const { return narrower >= 0 && !narrowBelow ? narrower : ci95; }
    [[nodiscard]] double low() const { return value - below(); }
    [[nodiscard]] double high() const { return value + above(); }
    /// The same with so much more on the upper side: what may be there beside what was found.
    [[nodiscard]] Interval widenedAbove(double more) const { return sides(value, below(), above() + more); }
    /// Half-width over value; 0 for an exact zero, infinite for an uncertain one.
    [[nodiscard]] double relative() const;
};

/// Mean and variance of a stream of values. Source: Welford 1962.
class MeanVariance {
public:
    void add(double x) {
        ++count_;
        const double delta = x - mean_;
        mean_ += delta / static_cast<double>(count_);
        m2_ += delta * (x - mean_);
    }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] double mean() const { return mean_; }
    /// Unbiased variance of one value; 0 for fewer than two.
    [[nodiscard]] double variance() const { return count_ > 1 ? m2_ / static_cast<double>(count_ - 1) : 0.0; }
    /// Variance of the mean.
    [[nodiscard]] double meanVariance() const { return count_ > 0 ? variance() / static_cast<double>(count_) : 0.0; }

private:
    std::size_t count_ = 0;
    double mean_ = 0;
    double m2_ = 0;
};

/// The two-sided 95 % quantile of Student's t with `degreesOfFreedom` >= 1 (1.96 as it grows).
double studentT95(double degreesOfFreedom);

/// The 95 % interval of a mean whose estimate is skewed, Student's t straightened by Hall's transformation: where rare
/// large values make the mean, it reaches far up and little down. For Poisson counts it is within a few percent of the
/// exact interval from three events on. docs/decisions/0012 has the measured coverage.
///
/// sigma       of the mean, estimated
/// skewness    of the mean: its third central moment over sigma^3, estimated [-]
/// degreesOfFreedom  of sigma
/// source      Hall 1992, "On the removal of skewness by transformation", JRSS B 54
Interval skewedInterval(double value, double sigma, double skewness, double degreesOfFreedom);

/// The mean of independent, equally good replicate means with its 95 % interval (skewedInterval(), R - 1
/// degrees of freedom).
///
/// replicates  #R  means of independently scrambled sample sets, R >= 2
Interval meanOfReplicates(std::span<const double> replicates);

/// Ēm, Emin and Uo of a grid, each with its own interval.
struct GridInterval {
    Interval mean;
    Interval minimum;
    Interval uniformity;       // Emin / Ēm [-]
    std::size_t minimumPoint;  // index of the point that is most likely the darkest
};

/// Intervals of the statistics of a grid of Monte Carlo estimates. The mean's interval is not that of
/// its points (their errors are independent and average out), and the smallest of noisy values is
/// biased low: `minimum` is corrected for that, so it may lie above the smallest point's value. See
/// docs/decisions/0003-grid-intervals.md for the derivation and the measured coverage.
///
/// replicates  #N x R, row-major  replicate means of every point [lx]; points are independent of each other
/// returns     no random draws: same replicates, same bits. A mean of 0 has an unknown uniformity.
/// errors      none; N >= 1, R >= 2 is the caller's duty (asserted)
/// valid for   covers as stated from R = 16 on; with fewer the points' own errors are too badly known
/// cost        O(N R), and 64 error functions for each point that may be the darkest
GridInterval gridInterval(std::span<const double> replicates, std::size_t pointCount);

}  // namespace luxdeck
