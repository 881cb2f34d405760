#include "analysis/grids/sampling_run.h"

#include "engine/core/parallel.h"

#include <algorithm>

namespace luxdeck {

namespace {

constexpr double kSliceSeconds = 0.25;

/// A target's share of a round is split so that even one target keeps all threads busy.
constexpr std::uint32_t kMostPerTask = 64;  // samples of each replicate: 2048 paths

struct Task {
    std::size_t target;
    std::uint32_t first, count;
    PointSums sums;
    TransportCounters counters;
    bool done = false;
};

}  // namespace

double SamplingRun::pathsPerSecond() const {
    return busySeconds_ > 0 ? static_cast<double>(counters_.paths) / busySeconds_ : 0;
}

bool SamplingRun::round(const std::vector<std::uint32_t>& request, const Progress& progress, ProgressState& state,
                        std::optional<double> deadline) {
    const auto stop = [&] { return progress.cancelled() || (deadline && seconds() >= *deadline); };
    const double begun = seconds(), leftThen = state.secondsLeft;
    std::size_t first = 0;
    while (first < request.size()) {
        if (stop()) return false;
        // As many targets as take about a quarter second at the rate seen so far; a few at first.
        const double paths = std::max(pathsPerSecond() * kSliceSeconds, 16384.0);
        std::size_t last = first;
        double planned = 0;
        while (last < request.size() && planned < paths) planned += double{kReplicates} * request[last++];
        runSlice(request, {first, last}, progress, deadline);
        first = last;
        tell(state, begun, leftThen, deadline);
        progress.report(state);
    }
    return !stop();
}

void SamplingRun::tell(ProgressState& state, double begun, double leftThen, std::optional<double> deadline) const {
    state.rate = static_cast<double>(counters_.rays) / std::max(busySeconds_, 1e-9) * 1e-6;
    state.rateUnit = "Mray/s";
    const double now = seconds();
    if (leftThen >= 0) state.secondsLeft = std::max(0.0, leftThen - (now - begun));
    if (deadline) state.secondsLeft = std::min(leftThen >= 0 ? state.secondsLeft : *deadline, std::max(0.0, *deadline - now));
    if (state.secondsLeft >= 0) state.fraction = now / (now + state.secondsLeft);
}

void SamplingRun::runSlice(const std::vector<std::uint32_t>& request, Slice slice, const Progress& progress,
                           std::optional<double> deadline) {
    std::vector<Task> tasks;
    for (std::size_t i = slice.first; i < slice.last; ++i)
        for (std::uint32_t from = 0; from < request[i]; from += kMostPerTask)
            tasks.push_back({i, sums_[i].perReplicate + from, std::min(kMostPerTask, request[i] - from), {}, {}});
    const Stopwatch busy;
    parallelFor(tasks.size(), [&](std::size_t t) {
        auto& task = tasks[t];
        if (progress.cancelled() || (deadline && seconds() >= *deadline)) return;
        task.sums = measure(estimator_, weights_, targets_[task.target], seed_, task.first, task.count, task.counters);
        task.done = true;
    });
    busySeconds_ += busy.seconds();
    for (std::size_t t = 0; t < tasks.size();) {
        const std::size_t target = tasks[t].target;
        std::size_t end = t;
        bool whole = true;
        for (; end < tasks.size() && tasks[end].target == target; ++end) whole = whole && tasks[end].done;
        for (; t < end; ++t) {
            counters_ += tasks[t].counters;
            if (whole) sums_[target].add(tasks[t].sums);
        }
    }
}

}  // namespace luxdeck
