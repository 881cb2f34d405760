#include "tonemap/histogram.h"

#include "tonemap/adaptation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace luxdeck::tonemap {

namespace {

double logRange(const DisplayModel& display) { return std::log(display.maxCdM2 / display.minCdM2); }

/// The middle of the display's range, in brightness [cd/m^2].
double middle(const DisplayModel& display) { return std::sqrt(display.maxCdM2 * display.minCdM2); }

/// One factor for the whole picture: the luminances' geometric mean shows as the display's middle (camera), or
/// what is just noticeable in the scene as just noticeable on the display (human; Ward 1994).
double linearFactor(std::span<const double> luminances, const DisplayModel& display, Ceiling ceiling) {
    double sum = 0, brightest = 0;
    std::size_t count = 0;
    for (const double l : luminances) {
        brightest = std::max(brightest, l);
        if (l < kDarkestVisible) continue;
        sum += std::log(l);
        ++count;
    }
    const double mean = count > 0 ? std::exp(sum / static_cast<double>(count)) : kDarkestVisible;
    const double mid = middle(display);
    const double factor =
        ceiling == Ceiling::Linear ? mid / mean : justNoticeableDifference(mid) / justNoticeableDifference(mean);
    // Where all of the scene's range fits, none of it is sent past white.
    const double darkest = luminances.empty() ? 0 : *std::ranges::min_element(luminances);
    const bool fits = darkest > 0 && brightest / darkest <= display.maxCdM2 / display.minCdM2;
    return fits ? std::min(factor, display.maxCdM2 / brightest) : factor;
}

}  // namespace

double LogHistogram::total() const { return std::accumulate(counts.begin(), counts.end(), 0.0); }

LogHistogram logHistogram(std::span<const double> luminances, int bins) {
    LogHistogram out{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), {}};
    for (const double l : luminances) {
        if (l < kDarkestVisible) continue;
        out.minLog = std::min(out.minLog, std::log(l));
        out.maxLog = std::max(out.maxLog, std::log(l));
    }
    if (!(out.maxLog > out.minLog)) return out;
    out.counts.resize(static_cast<std::size_t>(bins));
    for (const double l : luminances) {
        if (l < kDarkestVisible) continue;
        const auto bin = static_cast<std::size_t>((std::log(l) - out.minLog) / out.binWidth());
        out.counts[std::min(bin, out.counts.size() - 1)] += 1;
    }
    return out;
}

ToneCurve ToneCurve::linear(double factor, const DisplayModel& display) {
    ToneCurve curve;
    curve.display_ = display;
    curve.factor_ = factor;
    return curve;
}

ToneCurve ToneCurve::fromHistogram(const LogHistogram& histogram, const DisplayModel& display) {
    ToneCurve curve;
    curve.display_ = display;
    curve.minLog_ = histogram.minLog;
    curve.maxLog_ = histogram.maxLog;
    const double total = histogram.total();
    double sum = 0;
    curve.edges_.push_back(0);
    for (const double count : histogram.counts) curve.edges_.push_back((sum += count) / total);
    return curve;
}

double ToneCurve::displayLuminance(double worldCdM2) const {
    if (isLinear()) return std::clamp(factor_ * worldCdM2, display_.minCdM2, display_.maxCdM2);
    if (!(worldCdM2 > 0)) return display_.minCdM2;
    const auto bins = static_cast<double>(edges_.size() - 1);
    const double position = std::clamp((std::log(worldCdM2) - minLog_) / (maxLog_ - minLog_) * bins, 0.0, bins);
    const auto bin = std::min(static_cast<std::size_t>(position), edges_.size() - 2);
    const double fraction = position - static_cast<double>(bin);
    const double below = edges_[bin] * (1 - fraction) + edges_[bin + 1] * fraction;
    return display_.minCdM2 * std::exp(logRange(display_) * below);
}

double ceilingSlope(Ceiling ceiling, double worldCdM2, double displayCdM2) {
    if (ceiling == Ceiling::Linear) return 1;
    return justNoticeableDifference(displayCdM2) / justNoticeableDifference(worldCdM2) * worldCdM2 / displayCdM2;
}

AdjustedHistogram adjustHistogram(LogHistogram histogram, const DisplayModel& display, Ceiling ceiling,
                                  double tolerance) {
    const double original = histogram.total(), slack = tolerance * original;
    AdjustedHistogram out;
    double trimmings = original;
    while (trimmings > slack) {
        const double total = histogram.total();
        if (total < slack) return {std::move(histogram), false, out.passes, total / original};
        const auto curve = ToneCurve::fromHistogram(histogram, display);
        const double unitSlope = total * histogram.binWidth() / logRange(display);  // the count that gives slope 1
        trimmings = 0;
        for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
            const double world = std::exp(histogram.centre(bin));
            const double most = unitSlope * ceilingSlope(ceiling, world, curve.displayLuminance(world));
            trimmings += std::max(histogram.counts[bin] - most, 0.0);
            histogram.counts[bin] = std::min(histogram.counts[bin], most);
        }
        ++out.passes;
    }
    out.keptFraction = histogram.total() / original;
    out.histogram = std::move(histogram);
    out.useful = true;
    return out;
}

ToneCurve toneCurve(std::span<const double> luminances, const DisplayModel& display, Ceiling ceiling,
                    AdjustedHistogram* adjusted) {
    auto histogram = logHistogram(luminances);
    AdjustedHistogram result;
    const bool wider = !histogram.counts.empty() && histogram.maxLog - histogram.minLog > logRange(display);
    if (wider) result = adjustHistogram(std::move(histogram), display, ceiling);
    else result.histogram = std::move(histogram);
    const auto curve = result.useful ? ToneCurve::fromHistogram(result.histogram, display)
                                     : ToneCurve::linear(linearFactor(luminances, display, ceiling), display);
    if (adjusted != nullptr) *adjusted = std::move(result);
    return curve;
}

}  // namespace luxdeck::tonemap
