#include "analysis/grids/sampling_run.h"
#include "analysis/validation/cie171.h"
#include "engine/algorithms/registry.h"
#include "engine/transport/lit_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace luxdeck {

namespace {

/// Samples of each replicate to begin with: enough that rare directions are met before an interval is believed.
constexpr std::uint32_t kFirst = 128;
/// Half a minute for the table: from here on only what is still much too noisy is sampled, to the last.
constexpr std::uint32_t kManyOfReplicate = 1U << 12, kMostOfReplicate = 1U << 15;
constexpr double kMuchTooNoisy = 0.75 * kCie171Noise;

/// Where the sensors of one quantity are among all.
struct Span {
    std::size_t first, count;
};

Interval part(const PointSums& sums, bool reflectedAlone) {
    return reflectedAlone ? meanOfReplicates(sums.indirectMeans()) : sums.total();
}

/// Sensors are independent of each other.
Interval valueOf(const Cie171Quantity& q, const std::vector<PointSums>& sums, Span span) {
    double value = 0, squares = 0;
    for (std::size_t i = 0; i < span.count; ++i) {
        const auto lux = part(sums[span.first + i], q.reflectedAlone);
        value += q.weights[i] * lux.value;
        squares += std::pow(q.weights[i] * lux.ci95, 2);
    }
    return {value, std::sqrt(squares)};
}

/// Doubles the samples of each quantity until it is known well enough.
void measureCase(const Cie171Case& one, const RadianceEstimator& estimator, const Scene& scene, std::uint64_t seed,
                 const Progress& progress, std::vector<Cie171Row>& rows) {
    std::vector<Target> targets;
    std::vector<Span> spans;
    for (const auto& q : one.quantities) {
        spans.push_back({targets.size(), q.sensors.size()});
        for (const auto& sensor : q.sensors) {
            Target target;
            target.sensor = sensor, target.stream = targets.size();
            targets.push_back(target);
        }
    }
    const Progress silent;
    ProgressState state;
    std::vector<std::uint32_t> request(targets.size(), kFirst);
    SamplingRun run(estimator, scene.weights, std::move(targets), seed);
    for (std::uint32_t soFar = kFirst;; soFar *= 2) {
        run.round(request, silent, state, std::nullopt);
        bool enough = true;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            rows[k].value = valueOf(one.quantities[k], run.sums(), spans[k]);
            const double wanted = soFar < kManyOfReplicate ? kCie171Precision : kMuchTooNoisy;
            const bool known = rows[k].value.ci95 <= wanted * rows[k].reference.value && rows[k].value.value > 0;
            if (known) std::fill_n(request.begin() + static_cast<std::ptrdiff_t>(spans[k].first), spans[k].count, 0U);
            else std::fill_n(request.begin() + static_cast<std::ptrdiff_t>(spans[k].first), spans[k].count, soFar);
            enough = enough && known;
        }
        if (enough || soFar >= kMostOfReplicate || progress.cancelled()) break;
    }
    if (run.counters().rejected > 0)
        for (auto& row : rows) row.refused = "samples that are not finite or negative";
}

Cie171Verdict judge(const Cie171Row& row) {
    const double reference = row.reference.value, off = std::abs(row.value.value - reference);
    if (!row.refused.empty() || !std::isfinite(row.value.value) || !std::isfinite(row.value.ci95)) return Cie171Verdict::Outside;
    const double error = row.value.ci95 / studentT95(kReplicates - 1);
    if (off > std::max(kCie171Tolerance * reference, kCie171Sigmas * error) + row.reference.error) return Cie171Verdict::Outside;
    return row.value.ci95 <= kCie171Noise * reference ? Cie171Verdict::Within : Cie171Verdict::TooNoisy;
}

std::optional<Error> tryCase(const Cie171Case& one, const std::string& algorithm, std::uint64_t seed, const Progress& progress,
                             std::vector<Cie171Row>& rows) {
    const auto scene = one.scene();
    if (!scene) return scene.error();
    const auto lit = LitScene::create(*scene);
    if (!lit) return lit.error();
    const auto estimator = makeEstimator(algorithm, lit->transport());
    if (!estimator) return estimator.error();
    measureCase(one, **estimator, *scene, seed, progress, rows);
    return std::nullopt;
}

}  // namespace

const char* verdictText(Cie171Verdict verdict) {
    switch (verdict) {
        case Cie171Verdict::Within: return "within";
        case Cie171Verdict::Outside: return "outside";
        case Cie171Verdict::TooNoisy: return "too noisy";
    }
    return "";
}

std::vector<Cie171Row> runCie171Case(const Cie171Case& one, const std::string& algorithm, std::uint64_t seed, const Progress& progress) {
    std::vector<Cie171Row> rows;
    for (const auto& q : one.quantities) {
        Cie171Row row;
        row.number = one.number, row.subject = one.subject, row.configuration = one.configuration, row.algorithm = algorithm;
        row.point = q.point, row.unit = q.unit, row.reference = q.reference;
        rows.push_back(std::move(row));
    }
    if (const auto error = tryCase(one, algorithm, seed, progress, rows))
        for (auto& row : rows) row.refused = error->text();
    for (auto& row : rows) row.verdict = judge(row);
    return rows;
}

std::vector<Cie171Row> runCie171(std::uint64_t seed, const Progress& progress, const std::string& number) {
    const Stopwatch clock;
    auto cases = cie171Cases();
    if (!number.empty()) std::erase_if(cases, [&](const auto& one) { return one.number != number; });
    std::vector<Cie171Row> out;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        for (const char* algorithm : {"path", "direct"}) {
            if (progress.cancelled()) return out;
            if (algorithm == std::string("direct") && !cases[i].straight) continue;
            auto rows = runCie171Case(cases[i], algorithm, seed, progress);
            std::move(rows.begin(), rows.end(), std::back_inserter(out));
        }
        ProgressState state;
        state.stage = "CIE 171";
        state.fraction = static_cast<double>(i + 1) / static_cast<double>(cases.size());
        state.secondsLeft = clock.seconds() * (1 / state.fraction - 1);
        progress.report(state);
    }
    return out;
}

}  // namespace luxdeck
