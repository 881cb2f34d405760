#include "analysis/grids/measurement.h"

#include "analysis/grids/layers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace luxdeck {

namespace {

/// Missed in all n samples, an event has at most this many expected ones, 97.5 % (Poisson: -log 0.025).
constexpr double kUnmet = 3.688879454113936;

}  // namespace

void PointSums::add(const PointSums& more) {
    for (std::size_t r = 0; r < kReplicates; ++r) direct[r] += more.direct[r], indirect[r] += more.indirect[r];
    for (std::size_t c = 0; c < 3; ++c) rgb[c] += more.rgb[c];
    if (layers.empty()) layers.assign(more.layers.size(), 0.0);
    for (std::size_t i = 0; i < more.layers.size(); ++i) layers[i] += more.layers[i];
    perReplicate += more.perReplicate, backFaces += more.backFaces, rejected += more.rejected;
    lost += more.lost, diffused += more.diffused, foundSquares += more.foundSquares;
    peak = std::max(peak, more.peak);
    lostAt = std::min(lostAt, more.lostAt);
}

bool PointSums::withheld() const {
    return static_cast<double>(rejected) > kMostLost * static_cast<double>(samples()) || !std::isfinite(lost);
}

bool PointSums::staysOpen() const {
    constexpr std::uint32_t kEnough = 4096;  // samples of each replicate: a share so near the limit is not worth more
    constexpr double kMany = 1e6;            // samples that a point may be given to meet light by chance
    const double n = std::max<double>(1, static_cast<double>(samples())), most = kMostLost * n;
    const bool surely = static_cast<double>(rejected) > most + 3 * std::sqrt(most) || !std::isfinite(lost);
    const bool tooRare = diffused > 0 && kUnmet * peak / kMany > diffused / n;
    return (withheld() && (surely || perReplicate >= kEnough)) || tooRare;
}

double PointSums::noise() const {
    if (withheld()) return staysOpen() ? 0 : std::numeric_limits<double>::infinity();
    const auto found = meanOfReplicates(totalMeans());
    return staysOpen() ? found.ci95 : found.widenedAbove(unmet()).ci95;
}

double PointSums::unseen() const {
    if (withheld()) return std::numeric_limits<double>::infinity();
    return lost / std::max<double>(1, static_cast<double>(samples())) + unmet();
}

double PointSums::unmet() const {
    if (!(diffused > 0)) return 0;
    // From three finds of that size on the spread of the replicates tells (docs/decisions/0012).
    constexpr double kEnoughFinds = 3;
    const double n = static_cast<double>(samples()), finds = peak > 0 ? foundSquares / (peak * peak) : 0;
    return (1 - std::min(1.0, finds / kEnoughFinds)) * std::min(diffused / n, kUnmet * peak / n);
}

namespace {

std::array<double, kReplicates> over(std::array<double, kReplicates> sums, double n) {
    for (auto& s : sums) s /= n;
    return sums;
}

/// Batches of a size that keeps the tracer's working set in the cache.
constexpr std::size_t kBatch = 512;

/// Of sensors asked together: larger, since each batch weighs the lights anew at each of them.
constexpr std::size_t kSharedBatch = 2048;

/// One sample of a target, in both forms that estimators answer.
struct Outcome {
    Rgb direct, indirect;
    bool backFace = false;
    RayFailure failure = RayFailure::None;
    Rgb lost;
    std::uint32_t lostAt = kNothing;
    ChanceLight chance;
};

Outcome outcomeOf(const RadianceSample& s) {
    return {s.emitted + s.direct, s.indirect, s.backFace, s.failure, s.lost, s.lostAt, s.chance};
}
Outcome outcomeOf(const SensorSample& s) {
    return {s.direct, s.indirect, s.sawBackFace, s.failure, s.lost, s.lostAt, s.chance};
}

std::vector<Outcome> ask(const RadianceEstimator& estimator, const Target& target, std::span<const SamplePath> numbers,
                         std::vector<SourceShare>& shares, TransportCounters& counters) {
    std::vector<Outcome> outcomes(numbers.size());
    if (target.radiance) {
        std::vector<RadianceQuery> queries(numbers.size());
        std::vector<RadianceSample> samples(numbers.size());
        for (std::size_t i = 0; i < numbers.size(); ++i) queries[i].ray = target.ray, queries[i].numbers = numbers[i];
        counters += estimator.radiance(queries, samples);
        for (std::size_t i = 0; i < numbers.size(); ++i) outcomes[i] = outcomeOf(samples[i]);
        return outcomes;
    }
    std::vector<SensorQuery> queries(numbers.size(), target.sensor);
    std::vector<SensorSample> samples(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) queries[i].numbers = numbers[i];
    counters += target.layers != nullptr ? estimator.irradianceBySource(queries, samples, shares)
                                         : estimator.irradiance(queries, samples);
    for (std::size_t i = 0; i < numbers.size(); ++i) outcomes[i] = outcomeOf(samples[i]);
    return outcomes;
}

void enter(PointSums& sums, std::size_t replicate, const Outcome& o, const LuminanceWeights& weights) {
    sums.direct[replicate] += luminance(o.direct, weights);
    sums.indirect[replicate] += luminance(o.indirect, weights);
    sums.rgb[0] += o.direct.r + o.indirect.r;
    sums.rgb[1] += o.direct.g + o.indirect.g;
    sums.rgb[2] += o.direct.b + o.indirect.b;
    sums.backFaces += o.backFace ? 1 : 0;
    sums.lost += o.lost.isBlack() ? 0 : luminance(o.lost, weights);
    const double found = o.chance.found;
    sums.diffused += o.chance.diffused, sums.foundSquares += found * found;
    sums.peak = std::max<double>(sums.peak, o.chance.peak);
    if (o.failure == RayFailure::None) return;
    ++sums.rejected;
    sums.lostAt = std::min(sums.lostAt, o.lostAt);
}

}  // namespace

std::array<double, kReplicates> PointSums::directMeans() const { return over(direct, perReplicate); }
std::array<double, kReplicates> PointSums::indirectMeans() const { return over(indirect, perReplicate); }

std::array<double, kReplicates> PointSums::totalMeans() const {
    auto means = directMeans();
    const auto more = indirectMeans();
    for (std::size_t r = 0; r < kReplicates; ++r) means[r] += more[r];
    return means;
}

Interval PointSums::interval(const std::array<double, kReplicates>& means) const {
    return meanOfReplicates(means).widenedAbove(unseen());
}

Rgb PointSums::rgbMean() const {
    const double n = std::max<double>(1, static_cast<double>(samples()));
    return {static_cast<float>(rgb[0] / n), static_cast<float>(rgb[1] / n), static_cast<float>(rgb[2] / n)};
}

PointSums measure(const RadianceEstimator& estimator, const LuminanceWeights& weights, const Target& target,
                  std::uint64_t seed, std::uint32_t first, std::uint32_t count, TransportCounters& counters) {
    PointSums sums;
    sums.perReplicate = count;
    std::vector<SamplePath> numbers;
    std::vector<SourceShare> shares;
    if (target.layers != nullptr) sums.layers.assign(target.layers->layers.size() * 2 * kReplicates, 0.0);
    numbers.reserve(kBatch);
    const std::size_t total = std::size_t{count} * kReplicates;
    for (std::size_t start = 0; start < total; start += kBatch) {
        const std::size_t end = std::min(total, start + kBatch);
        numbers.clear();
        for (std::size_t i = start; i < end; ++i)
            numbers.emplace_back(streamSeed(seed, target.stream, i / count), first + static_cast<std::uint32_t>(i % count));
        const auto outcomes = ask(estimator, target, numbers, shares, counters);
        for (const auto& share : shares)
            sums.layers[(2 * std::size_t{target.layers->layerOf(share.source)} + (share.direct ? 0 : 1)) * kReplicates +
                        (start + share.query) / count] += luminance(share.light, weights);
        for (std::size_t i = start; i < end; ++i) enter(sums, i / count, outcomes[i - start], weights);
    }
    return sums;
}

std::vector<PointSums> measureTogether(const RadianceEstimator& estimator, const LuminanceWeights& weights,
                                       std::span<const Target> targets, std::span<const std::size_t> members, std::uint64_t seed,
                                       std::span<const std::uint32_t> firsts, std::uint32_t count, TransportCounters& counters) {
    const std::size_t n = members.size();
    std::vector<PointSums> sums(n);
    for (auto& s : sums) s.perReplicate = count;
    const std::size_t perBatch = std::max<std::size_t>(1, kSharedBatch / n), total = std::size_t{count} * kReplicates;
    std::vector<SensorQuery> queries;
    std::vector<SensorSample> samples;
    for (std::size_t start = 0; start < total; start += perBatch) {
        const std::size_t end = std::min(total, start + perBatch);
        queries.clear();
        for (std::size_t i = start; i < end; ++i)
            for (std::size_t m = 0; m < n; ++m) {
                const auto& target = targets[members[m]];
                auto& query = queries.emplace_back(target.sensor);
                query.group = static_cast<std::uint32_t>(i - start);
                query.numbers = SamplePath(streamSeed(seed, target.stream, i / count), firsts[m] + static_cast<std::uint32_t>(i % count));
            }
        samples.resize(queries.size());
        counters += estimator.irradiance(queries, samples);
        for (std::size_t q = 0; q < queries.size(); ++q) {
            enter(sums[q % n], (start + q / n) / count, outcomeOf(samples[q]), weights);
        }
    }
    return sums;
}

}  // namespace luxdeck
