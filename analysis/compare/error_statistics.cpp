#include "analysis/compare/error_statistics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace luxdeck {

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Sums over all rows but one.
struct Moments {
    Field mean, meanVariance;
};

Moments momentsWithout(std::span<const Field> rows, std::size_t left) {
    const std::size_t n = rows.front().size();
    Moments out{Field(n), Field(n)};
    for (std::size_t i = 0; i < n; ++i) {
        MeanVariance values;
        for (std::size_t r = 0; r < rows.size(); ++r)
            if (r != left) values.add(rows[r][i]);
        out.mean[i] = values.mean(), out.meanVariance[i] = values.meanVariance();
    }
    return out;
}

/// The three figures of one choice of repetitions and parts.
struct Figures {
    double meanSquare = 0, biasSquare = 0, mean = 0;
};

Figures figuresOf(const Moments& truth, const Moments& values, const Field& scale, double repetitions) {
    Figures sum;
    const auto n = static_cast<double>(scale.size());
    for (std::size_t i = 0; i < scale.size(); ++i) {
        const double difference = values.mean[i] - truth.mean[i], weight = 1 / (scale[i] * scale[i]);
        const double bias = difference * difference - truth.meanVariance[i] - values.meanVariance[i];
        sum.biasSquare += weight * bias;
        sum.meanSquare += weight * (bias + repetitions * values.meanVariance[i]);  // the variance of one repetition
        sum.mean += difference / scale[i];
    }
    return {sum.meanSquare / n, sum.biasSquare / n, sum.mean / n};
}

/// The variance of a figure from what it is with each row left out.
double jackknifeVariance(std::span<const double> without) {
    const auto n = static_cast<double>(without.size());
    const double mean = std::accumulate(without.begin(), without.end(), 0.0) / n;
    double sum = 0;
    for (const double w : without) sum += (w - mean) * (w - mean);
    return (n - 1) / n * sum;
}

Interval intervalOf(double value, std::span<const double> withoutRepetition, std::span<const double> withoutPart) {
    const double a = jackknifeVariance(withoutRepetition), b = jackknifeVariance(withoutPart);
    if (!(a + b > 0)) return {value, 0};
    const double freedomA = static_cast<double>(withoutRepetition.size()) - 1, freedomB = static_cast<double>(withoutPart.size()) - 1;
    const double freedom = (a + b) * (a + b) / (a * a / freedomA + b * b / freedomB);
    return {value, studentT95(std::max(1.0, freedom)) * std::sqrt(a + b)};
}

/// |error| of one repetition, sorted.
Field sortedErrors(const Field& values, const Field& truth, const Field& scale) {
    Field errors(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) errors[i] = std::abs(values[i] - truth[i]) / scale[i];
    std::ranges::sort(errors);
    return errors;
}

/// The square root of a square with an interval, to first order.
Interval rootOf(const Interval& square) {
    const double root = std::sqrt(square.value);
    return {root, square.ci95 / (2 * root)};
}

}  // namespace

Field ReferenceFields::mean() const { return momentsWithout(parts, kNone).mean; }
Field ReferenceFields::variance() const { return momentsWithout(parts, kNone).meanVariance; }

double ReferenceFields::rmsError() const {
    const auto own = variance();
    double sum = 0;
    for (std::size_t i = 0; i < own.size(); ++i) sum += own[i] / (scale[i] * scale[i]);
    return std::sqrt(sum / static_cast<double>(own.size()));
}

bool RunErrors::belowReference() const { return meanSquare.value <= reference * reference; }

std::optional<Interval> RunErrors::rms() const {
    if (belowReference() || meanSquare.value <= 0) return std::nullopt;
    return rootOf(meanSquare);
}

double RunErrors::rmsAtMost() const { return std::sqrt(std::max({0.0, meanSquare.high(), reference * reference})); }

std::optional<Interval> RunErrors::bias() const {
    if (biasSquare.low() <= 0) return std::nullopt;
    return rootOf(biasSquare);
}

RunErrors runErrors(const ReferenceFields& reference, std::span<const Field> repetitions) {
    const auto truth = momentsWithout(reference.parts, kNone), values = momentsWithout(repetitions, kNone);
    const auto k = static_cast<double>(repetitions.size());
    const auto whole = figuresOf(truth, values, reference.scale, k);
    std::vector<Figures> withoutRepetition, withoutPart;
    for (std::size_t r = 0; r < repetitions.size(); ++r)
        withoutRepetition.push_back(figuresOf(truth, momentsWithout(repetitions, r), reference.scale, k - 1));
    for (std::size_t p = 0; p < reference.parts.size(); ++p)
        withoutPart.push_back(figuresOf(momentsWithout(reference.parts, p), values, reference.scale, k));
    const auto interval = [&](double Figures::* figure) {
        std::vector<double> a, b;
        for (const auto& f : withoutRepetition) a.push_back(f.*figure);
        for (const auto& f : withoutPart) b.push_back(f.*figure);
        return intervalOf(whole.*figure, a, b);
    };
    RunErrors out{interval(&Figures::meanSquare), interval(&Figures::biasSquare), interval(&Figures::mean), 0, 0, reference.rmsError()};
    for (const auto& repetition : repetitions) {
        const auto errors = sortedErrors(repetition, truth.mean, reference.scale);
        out.largest += errors.back() / k;
        const auto rank = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(errors.size()))));
        out.percentile99 += errors[rank - 1] / k;
    }
    return out;
}

std::optional<Interval> logLogSlope(std::span<const CurvePoint> points) {
    const bool exact = std::ranges::all_of(points, [](const auto& p) { return !(p.relativeCi95 > 0); });
    double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0;
    const auto weightOf = [&](const CurvePoint& p) { return exact ? 1.0 : std::pow(1.96 / std::max(p.relativeCi95, 1e-6), 2); };
    for (const auto& p : points) {
        const double weight = weightOf(p), x = std::log(p.seconds), y = std::log(p.rms);
        w += weight, wx += weight * x, wy += weight * y, wxx += weight * x * x, wxy += weight * x * y;
    }
    const double spread = wxx - wx * wx / w;
    if (points.size() < 2 || !(spread > 1e-12 * wxx)) return std::nullopt;
    const double slope = (wxy - wx * wy / w) / spread, intercept = (wy - slope * wx) / w;
    const double freedom = static_cast<double>(points.size()) - 2;
    double off = 0;
    for (const auto& p : points) {
        const double residual = std::log(p.rms) - intercept - slope * std::log(p.seconds);
        off += weightOf(p) * residual * residual;
    }
    // What the points' errors explain, or what their scatter shows where it is more.
    const double explained = exact ? 0 : 1.96 * std::sqrt(1 / spread);
    const double seen = freedom > 0 ? studentT95(freedom) * std::sqrt(off / freedom / spread) : 0;
    return Interval{slope, freedom > 0 || !exact ? std::max(explained, exact || off > freedom ? seen : 0.0) : INFINITY};
}

namespace {

/// Where ln(rms) on the line through two runs comes to that of `error`.
double crossing(const CurvePoint& a, const CurvePoint& b, double error) {
    const double part = std::log(error / a.rms) / std::log(b.rms / a.rms);
    return a.seconds * std::pow(b.seconds / a.seconds, part);
}

}  // namespace

TimeTo timeToError(std::span<const CurvePoint> points, double error) {
    if (points.empty() || points.back().rms > error) return {};
    std::size_t above = points.size();  // the last run that is above the error
    while (above > 0 && points[above - 1].rms <= error) --above;
    if (above == 0) return {Reached::AtOnce, points.front().seconds};
    return {Reached::Interpolated, crossing(points[above - 1], points[above], error)};
}

CurvePoint errorAt(std::span<const CurvePoint> points, double seconds) {
    const auto after = std::ranges::find_if(points, [&](const auto& p) { return p.seconds >= seconds; });
    if (after == points.begin() || after == points.end()) {
        const auto& end = after == points.end() ? points.back() : points.front();
        return {seconds, end.rms, end.relativeCi95};
    }
    const auto& a = *std::prev(after);
    const double part = std::log(seconds / a.seconds) / std::log(after->seconds / a.seconds);
    return {seconds, a.rms * std::pow(after->rms / a.rms, part), part < 0.5 ? a.relativeCi95 : after->relativeCi95};
}

std::vector<int> places(std::span<const CurvePoint> errors) {
    std::vector<std::size_t> order(errors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return errors[i].rms; });
    std::vector<int> out(errors.size());
    std::size_t best = 0;  // of those that share the place
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto &first = errors[order[best]], &own = errors[order[i]];
        const double told = std::max(std::log1p(kTie), std::hypot(first.relativeCi95, own.relativeCi95));
        if (i > 0 && !(std::log(own.rms / first.rms) <= told)) best = i;
        out[order[i]] = static_cast<int>(best) + 1;
    }
    return out;
}

}  // namespace luxdeck
