#pragma once

#include "engine/core/statistics.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace luxdeck {

/// One number for each point of a grid or pixel of a picture, #N.
using Field = std::vector<double>;

/// What is held to be the truth, with its own noise: independent, equally good estimates of the same field.
///
/// parts    #R x N, R >= 3; their mean is the reference
/// scale    #N  errors are told relative to this [unit of the values], > 0
struct ReferenceFields {
    std::vector<Field> parts;
    Field scale;

    [[nodiscard]] std::size_t size() const { return scale.size(); }
    [[nodiscard]] Field mean() const;
    /// Of the mean, unbiased, #N.
    [[nodiscard]] Field variance() const;
    /// Root mean square over the points of the standard error of the mean over the scale.
    [[nodiscard]] double rmsError() const;
};

/// How far the repetitions of one run are from the truth, the reference's noise taken out.
struct RunErrors {
    Interval meanSquare;      // of (value - truth) / scale, over repetitions and points
    Interval biasSquare;      // of what the mean of endless repetitions would keep
    Interval mean;            // signed: of (value - truth) / scale
    double largest = 0;       // mean over the repetitions of the largest |error|; the reference's noise is in it
    double percentile99 = 0;  // likewise of the 99th percentile
    double reference = 0;     // rmsError() of the reference

    /// The run is nearer to the truth than the reference is known to be: no error is told, only a bound.
    [[nodiscard]] bool belowReference() const;
    /// Root mean square error and its interval; none when it is below the reference.
    [[nodiscard]] std::optional<Interval> rms() const;
    /// At most this, by the upper end of its interval.
    [[nodiscard]] double rmsAtMost() const;
    /// The part that repetition does not cure, and its interval; none while it cannot be told from nothing.
    [[nodiscard]] std::optional<Interval> bias() const;
};

/// Errors of independent repetitions of one run against a noisy reference. Unbiased: the reference's variance, estimated
/// from its parts, is subtracted from the squares, and for the bias that of the repetitions' mean too. Intervals by the
/// jackknife over repetitions and over parts (Student's t, Satterthwaite's degrees of freedom); they hold whether
/// the errors of points go together or not.
///
/// repetitions  #K x N, K >= 3: two must be left when one is left out
/// returns      pure; same fields, same bits
/// cost         O((K + R)^2 N)
/// source       Efron & Stein 1981 (jackknife); Satterthwaite 1946
RunErrors runErrors(const ReferenceFields& reference, std::span<const Field> repetitions);

/// One point of a curve of error against run time.
struct CurvePoint {
    double seconds = 0;      // > 0
    double rms = 0;          // > 0
    double relativeCi95 = 0; // half-width of rms over rms
};

/// The slope of ln(error) over ln(seconds), least squares weighted by the points' own errors, with its interval: from these
/// errors, widened where the points lie further off the line than they explain. None for fewer than two different times.
///
/// points  with relativeCi95 > 0, or all exact (then all weigh the same, and the scatter alone makes the interval)
std::optional<Interval> logLogSlope(std::span<const CurvePoint> points);

/// When a curve came down to an error.
enum class Reached { Interpolated, AtOnce, NotReached };
struct TimeTo {
    Reached how = Reached::NotReached;
    double seconds = 0;      // AtOnce: of the first run, an upper bound; NotReached: 0
};

/// The time from which the curve stays at or below `error`: on the straight line, in logarithms, between the two runs
/// around it. Nothing is extrapolated.
///
/// points  by increasing seconds; may be empty
TimeTo timeToError(std::span<const CurvePoint> points, double error);

/// The error at a time on the straight lines, in logarithms, between the points; beyond the ends that of the end.
/// The half-width is the nearer point's.
///
/// points  by increasing seconds, not empty
CurvePoint errorAt(std::span<const CurvePoint> points, double seconds);

/// Places from 1, best first. Errors within kTie of each other, or that their intervals cannot tell apart, share
/// a place, so that chance does not order equals.
///
/// errors  #A
/// returns places of each, #A
std::vector<int> places(std::span<const CurvePoint> errors);
inline constexpr double kTie = 0.1;

}  // namespace luxdeck
