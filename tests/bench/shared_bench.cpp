// shared/<room>: seconds to 2 % on every number of a room's grids, `path` and `shared` in turn in one run. Rooms of the
// shared data, where there are any, get a grid of their own at desk height.

#include "analysis/grids/solver.h"
#include "tests/bench/measuring.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace luxdeck::bench {

namespace {

namespace fs = std::filesystem;

constexpr double kTargetError = 0.02;
constexpr double kMostSeconds = 120;  // of one solve: what takes longer is told as that long

struct Room {
    const char* name;
    std::vector<const char*> files;       // a project, or a Radiance scene's files
    Vec3d low{0, 0, 0}, high{0, 0, 0};    // corners of the grid of a scene that has none [the file's unit]
};

std::vector<Room> rooms() {
    return {{"office", {"projects/office/project.toml"}},
            {"classroom", {"projects/classroom/project.toml"}},
            {"gallery", {"projects/gallery/project.toml"}},
            {"office2", {"../shared/data/scenes/office2/office2.rad"}, {0.5, 0.5, 0.8}, {3.5, 5.2, 0.8}},
            {"daylit_room",
             {"../shared/data/scenes/daylit_room/materials.rad", "../shared/data/scenes/daylit_room/room.rad",
              "../shared/data/scenes/daylit_room/objects/Glazing.rad", "../shared/data/scenes/daylit_room/sky_overcast.rad"},
             {0.5, 0.5, 0.8},
             {5.6, 5.6, 0.8}},
            {"cornell_box", {"../shared/data/scenes/cornell_box/cornell.rad"}, {-0.45, -0.45, -0.45}, {0.45, 0.45, -0.45}}};
}

Result<Project> load(const Room& room) {
    std::vector<fs::path> files;
    for (const auto* file : room.files) files.push_back(fs::path(LUXDECK_SOURCE_DIR) / file);
    auto project = loadProject(files);
    if (project && project->grids.empty()) {
        CalculationGrid grid;
        grid.name = room.name;
        grid.origin = room.low;
        grid.u = {room.high.x - room.low.x, 0, 0};
        grid.v = {0, room.high.y - room.low.y, 0};
        grid.counts = {{10, 10}};
        project->grids.push_back(grid);
    }
    return project;
}

SolveResult solveWith(const Project& project, const LitScene& lit, const std::string& algorithm) {
    SolveSettings settings;
    settings.algorithm = algorithm, settings.targetError = kTargetError, settings.timeSeconds = kMostSeconds;
    return luxdeck::solve(project, lit, settings, Progress{}).value();
}

/// Means of all grids, within five standard errors: an interval is about two of them wide.
bool agree(const SolveResult& a, const SolveResult& b) {
    for (std::size_t g = 0; g < a.grids.size(); ++g) {
        const auto &x = a.grids[g].mean.interval, &y = b.grids[g].mean.interval;
        if (std::abs(x.value - y.value) > 2.5 * std::hypot(x.ci95, y.ci95) + 1e-5 * y.value) return false;
    }
    return true;
}

void solveBoth(benchmark::State& state, const Room& room) {
    const auto project = load(room);
    if (!project) {
        state.SkipWithError(project.error().text().c_str());
        return;
    }
    const auto lit = LitScene::create(project->scene).value();
    SolveResult path, shared;
    for (auto _ : state) path = solveWith(*project, lit, "path"), shared = solveWith(*project, lit, "shared");
    if (!agree(path, shared)) state.SkipWithError("the two algorithms differ");
    const auto what = fmt::format("{}, path, seconds to 2 %{}", room.name, path.targetReached ? "" : " (not reached)");
    record(what, path.seconds, "s");
    record(fmt::format("  shared: times faster{}", shared.targetReached ? "" : " (2 % not reached)"), path.seconds / shared.seconds, "", 1 / 1.1);
    state.counters["path s"] = path.seconds, state.counters["shared s"] = shared.seconds;
    state.counters["path Mpaths"] = static_cast<double>(path.samples) * 1e-6;
    state.counters["shared Mpaths"] = static_cast<double>(shared.samples) * 1e-6;
}

const bool registered = [] {
    for (const auto& room : rooms()) {
        if (!fs::exists(fs::path(LUXDECK_SOURCE_DIR) / room.files.front())) continue;
        benchmark::RegisterBenchmark(fmt::format("shared/{}", room.name).c_str(), [room](benchmark::State& state) { solveBoth(state, room); })
            ->Iterations(1)
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    }
    return true;
}();

}  // namespace

}  // namespace luxdeck::bench
