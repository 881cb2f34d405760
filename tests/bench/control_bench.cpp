// controlled/<project>: variance times seconds of `path` over that of `shared` and `controlled`, the same samples of every point of
// the project's grids, in turn in one run. Set-up apart, and as a part of a solve of the time that was measured.

#include "analysis/grids/grid_points.h"
#include "analysis/grids/measurement.h"
#include "analysis/grids/neighbours.h"
#include "engine/algorithms/registry.h"
#include "engine/core/statistics.h"
#include "engine/transport/lit_scene.h"
#include "tests/bench/measuring.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::bench {

namespace {

constexpr std::uint32_t kPerReplicate = 64;
constexpr std::uint32_t kWarmUp = 4;  // fills the tables of the sky, which all use

struct Spread {
    double value = 0, variance = 0;  // of the mean of kReplicates x kPerReplicate samples
};

struct Side {
    double seconds = 0, setUp = 0;
    std::vector<Spread> points;
};

std::vector<Spread> run(const Project& project, const RadianceEstimator& estimator, const std::vector<Target>& targets, std::uint32_t count, std::uint64_t seed) {
    std::vector<Spread> out(targets.size());
    TransportCounters counters;
    for (const auto& group : neighbours(targets, estimator.groupSize())) {
        const bool alone = estimator.groupSize() == 1;
        const std::vector<std::uint32_t> firsts(group.size(), 0);
        const auto sums = alone ? std::vector<PointSums>{measure(estimator, project.scene.weights, targets[group.front()], seed, 0, count, counters)}
                                : measureTogether(estimator, project.scene.weights, targets, group, seed, firsts, count, counters);
        for (std::size_t i = 0; i < group.size(); ++i) {
            MeanVariance mv;
            for (const double m : sums[i].totalMeans()) mv.add(m);
            out[group[i]] = {mv.mean(), mv.meanVariance()};
        }
    }
    return out;
}

Side measureOne(const Project& project, const LitScene& lit, const std::string& algorithm, const std::vector<Target>& targets) {
    Side side;
    std::unique_ptr<RadianceEstimator> estimator;
    side.setUp = secondsOf(wallSeconds, [&] { estimator = makeEstimator(algorithm, lit.transport()).value(); });
    run(project, *estimator, targets, kWarmUp, 7);
    side.seconds = secondsOf(threadSeconds, [&] { side.points = run(project, *estimator, targets, kPerReplicate, 1); });
    return side;
}

/// How much less variance times seconds, in the mean of relative variances, or at the median point.
double gain(const Side& path, const Side& other, bool atMedian) {
    double before = 0, after = 0;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const auto &a = path.points[i], &b = other.points[i];
        if (!(b.variance > 0)) continue;
        before += a.variance / (a.value * a.value), after += b.variance / (b.value * b.value);
        ratios.push_back(a.variance / b.variance);
    }
    return (atMedian ? median(ratios) : before / after) * path.seconds / other.seconds;
}

bool agree(const Side& a, const Side& b) {
    double difference = 0, variance = 0;
    for (std::size_t i = 0; i < a.points.size(); ++i) difference += a.points[i].value - b.points[i].value, variance += a.points[i].variance;
    // Errors of neighbours go together in `b`: the sum's error is at most that of groups of 32 that err as one.
    return std::abs(difference) < 4 * std::sqrt(2 * 32 * variance);
}

void contestOn(benchmark::State& state, const std::string& name) {
    const auto project = loadProject(std::string(LUXDECK_SOURCE_DIR) + "/projects/" + name + "/project.toml").value();
    const auto lit = LitScene::create(project.scene).value();
    auto targets = gridTargets(project);
    std::size_t index = 0;
    for (std::uint32_t g = 0; g < project.grids.size(); ++g)
        for (auto left = layOut(project.grids[g]).value().points.size(); left > 0; --left) targets[index++].grid = g;
    Side path, shared, controlled;
    for (auto _ : state) {
        path = measureOne(project, lit, "path", targets);
        shared = measureOne(project, lit, "shared", targets);
        controlled = measureOne(project, lit, "controlled", targets);
    }
    if (!agree(path, shared) || !agree(path, controlled)) state.SkipWithError("the algorithms differ");
    record(fmt::format("{}, shared: variance x seconds of path over its own", name), gain(path, shared, false), "");
    record("  at the median point", gain(path, shared, true), "");
    record(fmt::format("{}, controlled: the same", name), gain(path, controlled, false), "", 4);
    record("  at the median point", gain(path, controlled, true), "");
    record("  with its set-up, in a solve of 30 s", gain(path, controlled, false) * (30 - controlled.setUp) / 30, "");
    record("  set-up", controlled.setUp, "s");
}

const bool registered = [] {
    for (const std::string name : {"office", "classroom", "gallery"})
        benchmark::RegisterBenchmark(fmt::format("controlled/{}", name).c_str(), [name](benchmark::State& state) { contestOn(state, name); })
            ->Iterations(1)
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace

}  // namespace luxdeck::bench
