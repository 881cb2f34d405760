// solve/<scene>/<algorithm>/<budget>: time and achieved error of every registered algorithm. A wrong answer fails.

#include "tests/bench/solve_bench.h"

#include "analysis/grids/solver.h"
#include "engine/algorithms/registry.h"
#include "engine/core/parallel.h"
#include "tests/bench/measuring.h"
#include "tests/support/scenes.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>

namespace luxdeck::bench {

namespace {

/// Five standard errors: of a thousand runs of all these cases none is expected to pass it by chance.
constexpr double kMostSigmas = 5;

struct Mean {
    double lux, standardError;
};

/// One of the small rooms with the sensors whose mean illuminance is asked for.
struct Room {
    std::string name;
    test::Lit lit;
    std::vector<Target> targets;
};

/// `side` x `side` sensors at the middles of the cells of a parallelogram, normal u x v.
void addSensors(std::vector<Target>& targets, Vec3 origin, Vec3 u, Vec3 v, int side) {
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const float s = (static_cast<float>(i) + 0.5F) / static_cast<float>(side);
            const float t = (static_cast<float>(j) + 0.5F) / static_cast<float>(side);
            Target target;
            target.sensor = {origin + u * s + v * t, cross(u, v).normalized(), SensorKind::Planar, {}};
            target.stream = targets.size();
            targets.push_back(target);
        }
}

constexpr double kCubeReflectance = 0.5, kCubeLumens = 1000, kCubeSide = 4;

Room& cube() {
    static Room room{"cubeRoom", test::Lit(test::cubeRoom(kCubeReflectance, kCubeLumens)), {}};
    if (room.targets.empty()) {
        const Vec3 x{4, 0, 0}, y{0, 4, 0}, z{0, 0, 4}, far{4, 4, 4};
        for (const auto& [u, v] : {std::pair{x, y}, std::pair{y, z}, std::pair{z, x}}) {
            addSensors(room.targets, {0, 0, 0}, u, v, 12);
            addSensors(room.targets, far, -v, -u, 12);  // (-v) x (-u) points back into the cube
        }
    }
    return room;
}

Room& furnished() {
    static Room room{"furnishedRoom", test::Lit(test::furnishedRoom()), {}};
    if (room.targets.empty()) addSensors(room.targets, {0, 0, 0.75F}, {6, 0, 0}, {0, 4, 0}, 6);
    return room;
}

Mean meanOf(const SamplingRun& run) {
    double lux = 0, variance = 0;
    for (const auto& sums : run.sums()) {
        MeanVariance mv;
        for (const double m : sums.totalMeans()) mv.add(m);
        lux += mv.mean(), variance += mv.meanVariance();
    }
    const auto n = static_cast<double>(run.sums().size());
    return {lux / n, std::sqrt(variance) / n};
}

struct RoomRun {
    Mean mean;
    TransportCounters counters;
    double seconds;
};
RoomRun runRoom(const Room& room, const std::string& algorithm, std::uint32_t samples, std::uint64_t seed) {
    const auto estimator = room.lit.estimator(algorithm);
    SamplingRun run(*estimator, room.lit.scene.weights, room.targets, seed);
    ProgressState state;
    const Stopwatch clock;
    run.round(std::vector<std::uint32_t>(room.targets.size(), samples / kReplicates), Progress{}, state, std::nullopt);
    return {meanOf(run), run.counters(), clock.seconds()};
}

/// What the room's mean is, from 4 times the largest budget with another seed.
const Mean& reference(const Room& room, const std::string& algorithm) {
    static std::map<std::string, Mean> known;
    const auto key = room.name + "/" + algorithm;
    auto it = known.find(key);
    if (it == known.end()) it = known.emplace(key, runRoom(room, algorithm, 4 * 1024, 99).mean).first;
    return it->second;
}

/// Mean illuminance of a closed uniform matte room: what enters, over what its walls absorb.
double cubeMeanLux() { return kCubeLumens / ((1 - kCubeReflectance) * 6 * kCubeSide * kCubeSide); }

void solveRoom(benchmark::State& state, Room& (*which)(), const Algorithm& algorithm, std::uint32_t samples) {
    const auto& room = which();
    const Mean expected = reference(room, algorithm.name);
    RoomRun run{};
    for (auto _ : state) run = runRoom(room, algorithm.name, samples, 1);
    const double sigma = std::hypot(run.mean.standardError, expected.standardError);
    const double slack = 1e-5 * expected.lux;  // float sums, where an algorithm has no noise
    if (std::abs(run.mean.lux - expected.lux) > kMostSigmas * sigma + slack)
        state.SkipWithError(fmt::format("{} lx, expected {} lx", run.mean.lux, expected.lux).c_str());
    // 12 x 12 midpoints a wall integrate its smooth illuminance to 0.2 %.
    if (room.name == "cubeRoom" && algorithm.interreflection &&
        std::abs(run.mean.lux - cubeMeanLux()) > kMostSigmas * run.mean.standardError + 2e-3 * cubeMeanLux())
        state.SkipWithError(fmt::format("{} lx, {} lx in closed form", run.mean.lux, cubeMeanLux()).c_str());
    state.counters["error %"] = 196 * run.mean.standardError / run.mean.lux;
    state.counters["rays/s"] = static_cast<double>(run.counters.rays) / run.seconds;
    state.counters["paths"] = static_cast<double>(run.counters.paths);
}

const LitScene& litOffice() {
    static const LitScene lit = LitScene::create(office().scene).value();
    return lit;
}

SolveResult solveOffice(const std::string& algorithm, std::uint64_t seed, double targetError, std::optional<std::uint32_t> samples) {
    SolveSettings settings;
    settings.algorithm = algorithm, settings.seed = seed, settings.targetError = targetError, settings.samples = samples;
    return luxdeck::solve(office(), litOffice(), settings, Progress{}).value();
}

/// Mean illuminance of every grid against another run's.
bool agree(const SolveResult& a, const SolveResult& b) {
    for (std::size_t g = 0; g < a.grids.size(); ++g) {
        const auto &x = a.grids[g].mean.interval, &y = b.grids[g].mean.interval;
        // Intervals are about two standard errors wide.
        if (std::abs(x.value - y.value) > kMostSigmas / 2 * std::hypot(x.ci95, y.ci95) + 1e-5 * y.value) return false;
    }
    return true;
}

void solveOfficeToError(benchmark::State& state, const Algorithm& algorithm, double targetError) {
    static std::map<std::string, SolveResult> references;
    if (!references.contains(algorithm.name)) references[algorithm.name] = solveOffice(algorithm.name, 99, 0, 2048);
    SolveResult result;
    for (auto _ : state) result = solveOffice(algorithm.name, 1, targetError, std::nullopt);
    if (!result.targetReached) state.SkipWithError("the target error was not reached");
    if (!agree(result, references[algorithm.name])) state.SkipWithError("a grid's mean differs from the longer run's");
    state.counters["error %"] = 100 * result.trace.back().relativeError;
    state.counters["paths"] = static_cast<double>(result.samples);
    state.counters["rays"] = static_cast<double>(result.rays);
    state.counters["rays/s"] = static_cast<double>(result.rays) / result.seconds;
    if (algorithm.name == "path") {
        record("office, path, seconds to 2 % on every number", result.seconds, "s");
        record("  paths", static_cast<double>(result.samples) * 1e-6, "million");
        record("  rays a second, all threads", static_cast<double>(result.rays) / result.seconds * 1e-6, "Mray/s");
    }
}

/// A solve of the office with two threads against one. Same bits, or it fails.
void threads(benchmark::State& state) {
    static constexpr std::uint32_t kSamples = 128;
    double one = 0, two = 0;
    Contest times;
    const auto runWith = [](int count) {
        const ThreadLimit limit(count);
        return solveOffice("path", 1, 0, kSamples).grids.front().mean.interval.value;
    };
    for (auto _ : state) times = contest(wallSeconds, 5, [&] { two = runWith(2); }, [&] { one = runWith(1); });
    if (one != two) state.SkipWithError("two threads gave other bits than one");
    state.counters["speed-up"] = times.ratio();
    record("office, path, speed-up from 1 to 2 threads", times.ratio(), "", 1.8);
}
BENCHMARK(threads)->Name("threads/office/path/1_to_2")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

void registerSolves() {
    const auto enter = [](const std::string& name, auto run) {
        benchmark::RegisterBenchmark(name.c_str(), run)->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);
    };
    for (const auto& algorithm : algorithms()) {
        for (const auto which : {&cube, &furnished})
            for (const std::uint32_t samples : {64U, 1024U})
                enter(fmt::format("solve/{}/{}/{}", which == &cube ? "cubeRoom" : "furnishedRoom", algorithm.name, samples),
                      [=, &algorithm](benchmark::State& state) { solveRoom(state, which, algorithm, samples); });
        enter(fmt::format("solve/office/{}/2%", algorithm.name),
              [&algorithm](benchmark::State& state) { solveOfficeToError(state, algorithm, 0.02); });
    }
}

}  // namespace luxdeck::bench
