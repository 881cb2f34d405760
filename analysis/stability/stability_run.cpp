#include "analysis/grids/sampling_run.h"
#include "analysis/stability/stability.h"
#include "engine/algorithms/registry.h"
#include "engine/transport/lit_scene.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

constexpr std::uint32_t kFirst = 16;  // samples of each replicate

/// The mean over the sensors; sensors are independent of each other.
Interval meanOf(const std::vector<PointSums>& sums) {
    double value = 0, squares = 0;
    for (const auto& s : sums) {
        const auto total = s.total();
        value += total.value, squares += total.ci95 * total.ci95;
    }
    const auto n = static_cast<double>(sums.size());
    return {value / n, std::sqrt(squares) / n};
}

bool preciseEnough(const Interval& lux, const Criterion& criterion, double precision) {
    return lux.ci95 <= precision * criterion.lux.value_or(lux.value) || lux.ci95 <= criterion.slackLux;
}

/// bias  of the algorithm, relative
StabilityVerdict judge(const StabilityResult& r, double precision, double bias) {
    const auto& c = r.expected;
    if (!std::isfinite(r.lux.value) || !std::isfinite(r.lux.ci95) || r.lux.value < 0 || r.counters.rejected > 0)
        return StabilityVerdict::Missed;
    if (!c.lux) return StabilityVerdict::Met;
    if (std::abs(r.lux.value - *c.lux) > kStabilitySigmas / 1.96 * r.lux.ci95 + c.slackLux + bias * *c.lux) return StabilityVerdict::Missed;
    return preciseEnough(r.lux, c, precision) ? StabilityVerdict::Met : StabilityVerdict::TooNoisy;
}

/// Doubles the samples until the interval is narrow enough.
void measureCase(const StabilityCase& one, const RadianceEstimator& estimator, const Scene& scene, std::uint64_t seed,
                 const Progress& progress, StabilityResult& out) {
    std::vector<Target> targets(one.sensors.size());
    for (std::size_t i = 0; i < targets.size(); ++i) targets[i].sensor = one.sensors[i], targets[i].stream = i;
    SamplingRun run(estimator, scene.weights, std::move(targets), seed);
    ProgressState state;
    const Progress silent;
    std::uint32_t more = kFirst;
    for (std::uint32_t paths = kFirst * kReplicates;; paths *= 2) {
        run.round(std::vector<std::uint32_t>(one.sensors.size(), more), silent, state, std::nullopt);
        out.lux = meanOf(run.sums());
        // Light that no path has met yet is 0 +- 0, which says nothing where there is some.
        const bool met = out.lux.value > 0 || out.expected.lux.value_or(0) == 0;
        if (progress.cancelled() || paths >= one.mostPaths || (met && preciseEnough(out.lux, out.expected, one.precision / 2))) break;
        more = paths / kReplicates;
    }
    out.counters = run.counters();
}

/// The error that refuses the case, if one does.
std::optional<Error> tryCase(const StabilityCase& one, const Algorithm& algorithm, std::uint64_t seed, const Progress& progress,
                             StabilityResult& out) {
    const auto scene = one.scene();
    if (!scene) return scene.error();
    const auto lit = LitScene::create(*scene);
    if (!lit) return lit.error();
    AlgorithmSettings settings;
    settings.seed = seed;
    const auto estimator = makeEstimator(algorithm.name, lit->transport(), settings);
    if (!estimator) return estimator.error();
    measureCase(one, **estimator, *scene, seed, progress, out);
    return std::nullopt;
}

}  // namespace

const char* verdictText(StabilityVerdict verdict) {
    switch (verdict) {
        case StabilityVerdict::Met: return "met";
        case StabilityVerdict::Missed: return "missed";
        case StabilityVerdict::TooNoisy: return "too noisy";
        case StabilityVerdict::KnownLimit: return "known limit";
    }
    return "";
}

StabilityResult runStabilityCase(const StabilityCase& one, const Algorithm& algorithm, std::uint64_t seed, const Progress& progress) {
    const Stopwatch clock;
    StabilityResult out;
    out.name = one.name, out.algorithm = algorithm.name;
    out.expected = algorithm.interreflection ? one.exact : one.straight;
    const auto refused = tryCase(one, algorithm, seed, progress, out);
    if (refused) out.refused = refused->text();
    const bool wanted = !out.expected.refusal.empty();
    if (!refused && !wanted) out.verdict = judge(out, one.precision, algorithm.bias);
    else if (refused && wanted && out.refused.find(out.expected.refusal) != std::string::npos) out.verdict = StabilityVerdict::Met;
    if (out.verdict != StabilityVerdict::Met && algorithm.limits.contains(one.name)) out.verdict = StabilityVerdict::KnownLimit;
    out.seconds = clock.seconds();
    return out;
}

std::vector<StabilityResult> runStability(std::uint64_t seed, const Progress& progress, const std::string& only) {
    const Stopwatch clock;
    std::vector<StabilityResult> out;
    const std::size_t count = stabilityCases().size() * (only.empty() ? algorithms().size() : 1);
    for (const auto& one : stabilityCases())
        for (const auto& algorithm : algorithms()) {
            if (!only.empty() && algorithm.name != only) continue;
            if (progress.cancelled()) return out;
            out.push_back(runStabilityCase(one, algorithm, seed, progress));
            ProgressState state;
            state.stage = "stability";
            state.fraction = static_cast<double>(out.size()) / static_cast<double>(count);
            state.secondsLeft = clock.seconds() * (1 / state.fraction - 1);
            progress.report(state);
        }
    return out;
}

}  // namespace luxdeck
