// What leaving out saves: equal samples with what a scene needs, and with everything.

#include "tests/bench/measuring.h"
#include "tests/support/scenes.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>

namespace luxdeck::bench {

namespace {

/// All stages on. How lights are chosen stays: that is another sampling, not a stage to be left out.
SceneNeeds everythingFor(const Scene& scene) {
    auto needs = SceneNeeds::everything();
    needs.manyLights = SceneNeeds::of(scene).manyLights;
    return needs;
}

/// Nine sensors that look up, spread over a horizontal rectangle in the scene's middle.
std::vector<Target> sensorsIn(const Scene& scene) {
    const Box3 box = scene.bounds();
    std::vector<Target> targets;
    for (int i = 0; i < 9; ++i) {
        const float x = 0.25F + 0.25F * static_cast<float>(i % 3), y = 0.25F + 0.25F * static_cast<float>(i / 3);
        Target target;
        target.sensor.position = {box.min.x + x * (box.max.x - box.min.x), box.min.y + y * (box.max.y - box.min.y), box.min.z + 0.85F};
        target.stream = static_cast<std::uint64_t>(i);
        targets.push_back(target);
    }
    return targets;
}

/// Mean illuminance of the targets.
double light(const test::Lit& lit, const RadianceEstimator& path, const std::vector<Target>& targets, std::uint32_t samples) {
    TransportCounters counters;
    double lux = 0;
    for (const auto& target : targets)
        lux += measure(path, lit.scene.weights, target, 1, 0, samples / kReplicates, counters).total().value;
    return lux / static_cast<double>(targets.size());
}

void leavingOut(benchmark::State& state, const std::string& name, const Scene& scene, std::uint32_t samples) {
    const test::Lit needed(scene, SceneNeeds::of(scene)), all(scene, everythingFor(scene));
    const auto neededPath = needed.estimator("path"), allPath = all.estimator("path");
    const auto targets = sensorsIn(scene);
    double some = 0, every = 0;
    Contest times;
    for (auto _ : state)
        times = contest(threadSeconds, 7, [&] { some = light(needed, *neededPath, targets, samples); }, [&] { every = light(all, *allPath, targets, samples); });
    // Other random numbers where a stage draws some: the noise of these budgets is below 1 % in all four scenes.
    if (!(some > 0) || std::abs(some - every) > 0.05 * every)
        state.SkipWithError(fmt::format("{} lx, with everything {} lx", some, every).c_str());
    const double paths = static_cast<double>(samples) * static_cast<double>(targets.size());
    state.counters["saved"] = times.ratio();
    state.counters["us/path"] = median(times.first) / paths * 1e6;
    state.counters["us/path all"] = median(times.second) / paths * 1e6;
    record(fmt::format("leaving out, {}: time with everything / needed", name), times.ratio(), "");
}

void leavingOutCube(benchmark::State& state) { leavingOut(state, "cubeRoom", test::cubeRoom(0.5F, 1000), 4096); }
void leavingOutFurnished(benchmark::State& state) { leavingOut(state, "furnishedRoom", test::furnishedRoom(), 2048); }
void leavingOutRich(benchmark::State& state) { leavingOut(state, "richRoom", test::richRoom(), 2048); }
void leavingOutOffice(benchmark::State& state) { leavingOut(state, "office", office().scene, 2048); }
BENCHMARK(leavingOutCube)->Name("leave_out/cubeRoom")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(leavingOutFurnished)->Name("leave_out/furnishedRoom")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(leavingOutRich)->Name("leave_out/richRoom")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(leavingOutOffice)->Name("leave_out/office")->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace luxdeck::bench
