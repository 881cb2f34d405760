#include "tests/gui/bench/gap_bench.h"

#include "engine/core/parallel.h"
#include "tests/gui/window/open_window.h"

#include <QElapsedTimer>
#include <QTimer>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <sched.h>
#include <string>
#include <vector>

namespace luxdeck::gui {

namespace {

constexpr int kWatchMs = 10'000;
constexpr int kSettleMs = 2000;
constexpr double kLongMs = 50;
constexpr double kLongRunSeconds = 60;  // the work outlasts what is watched

/// Threads that run already, and so all that they start.
void useOneCore() {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(0, &one);
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task"))
        (void)sched_setaffinity(std::stoi(task.path().filename().string()), sizeof one, &one);
}

/// Times between the ticks of a timer that is due all the time [ms], longest first.
std::vector<double> gaps(int watchMs) {
    std::vector<double> all;
    QElapsedTimer clock;
    clock.start();
    QTimer tick;
    tick.setInterval(1);
    tick.setTimerType(Qt::PreciseTimer);
    QObject::connect(&tick, &QTimer::timeout, [&] { all.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed())), clock.start(); });
    tick.start();
    QTest::qWait(watchMs);
    std::sort(all.rbegin(), all.rend());
    return all;
}

using Work = std::function<void(Session&)>;

void watch(benchmark::State& state, MainWindow::Workspace page, const Work& work) {
    useOneCore();
    const YieldingWorkers quick;
    const test::OwnFolder folder;
    const test::OpenWindow open;
    if (!open.open(folder.sample("office"))) return state.SkipWithError("the office cannot be opened");
    open.window->showWorkspace(page);
    QTest::qWait(kSettleMs);
    for (auto _ : state) {
        if (work) work(open.session());
        const auto all = gaps(kWatchMs);
        state.counters["longest ms"] = all.front();
        state.counters["99.9 % ms"] = all[all.size() / 1000];
        state.counters["over 50 ms"] = static_cast<double>(std::count_if(all.begin(), all.end(), [](double ms) { return ms > kLongMs; }));
        state.counters["ticks"] = static_cast<double>(all.size());
    }
    open.session().place.jobs.cancelAll();
    (void)open.untilIdle();
}

void solve(Session& session) {
    SolveSettings settings;
    settings.algorithm = "shared";
    settings.targetError = 0.0005;
    settings.timeSeconds = kLongRunSeconds;
    session.solving.start(settings);
}

void render(Session& session) {
    PictureRequest request;
    request.view = session.project()->project.views.front();
    request.settings.targetError = 0;
    request.settings.timeSeconds = kLongRunSeconds;
    if (const auto begun = session.pictures.render(request); !begun) session.place.complain(begun.error());
}

void compare(Session& session) {
    CompareSettings settings;
    settings.algorithms = {"path", "shared"};
    session.comparing.start(settings);
}

}  // namespace

void addGapBenches() {
    using Workspace = MainWindow::Workspace;
    const auto add = [](const char* name, Workspace page, const Work& work) {
        benchmark::RegisterBenchmark(name, [page, work](benchmark::State& state) { watch(state, page, work); })->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();
    };
    add("gui/longestGap/idle", Workspace::Room, {});
    add("gui/longestGap/solving", Workspace::Compare, solve);
    add("gui/longestGap/solving, the room in sight", Workspace::Room, solve);
    add("gui/longestGap/rendering", Workspace::Picture, render);
    add("gui/longestGap/comparing", Workspace::Compare, compare);
}

}  // namespace luxdeck::gui
