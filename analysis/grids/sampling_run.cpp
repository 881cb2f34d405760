#include "analysis/grids/sampling_run.h"

#include "engine/core/parallel.h"

#include <algorithm>

namespace luxdeck {

namespace {

constexpr double kSliceSeconds = 0.25;

/// A group's share of a round is split so that even one target keeps all threads busy.
constexpr std::uint32_t kMostPerTask = 64;  // samples of each replicate: 2048 paths

struct Task {
    std::size_t group;
    std::uint32_t first, count;
    std::vector<PointSums> sums;  // of the group's members
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
    while (first < groups_.size()) {
        if (stop()) return false;
        // As many groups as take about a quarter second at the rate seen so far; a few at first.
        const double paths = std::max(pathsPerSecond() * kSliceSeconds, 16384.0);
        std::size_t last = first;
        double planned = 0;
        while (last < groups_.size() && planned < paths) {
            planned += static_cast<double>(groups_[last].size()) * kReplicates * requestOf(last, request);
            ++last;
        }
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

std::uint32_t SamplingRun::requestOf(std::size_t group, const std::vector<std::uint32_t>& request) const {
    std::uint32_t most = 0;
    for (const auto member : groups_[group]) most = std::max(most, request[member]);
    return most;
}

void SamplingRun::runSlice(const std::vector<std::uint32_t>& request, Slice slice, const Progress& progress,
                           std::optional<double> deadline) {
    std::vector<Task> tasks;
    for (std::size_t g = slice.first; g < slice.last; ++g) {
        const auto& members = groups_[g];
        const auto most = std::max(4U, kMostPerTask / static_cast<std::uint32_t>(members.size()));
        const auto wanted = requestOf(g, request);
        for (std::uint32_t from = 0; from < wanted; from += most)
            tasks.push_back({g, sums_[members.front()].perReplicate + from, std::min(most, wanted - from), {}, {}});
    }
    const Stopwatch busy;
    parallelFor(tasks.size(), [&](std::size_t t) {
        auto& task = tasks[t];
        if (progress.cancelled() || (deadline && seconds() >= *deadline)) return;
        const auto& members = groups_[task.group];
        if (members.size() == 1)
            task.sums = {measure(estimator_, weights_, targets_[members.front()], seed_, task.first, task.count, task.counters)};
        else
            task.sums = measureTogether(estimator_, weights_, targets_, members, seed_, task.first, task.count, task.counters);
        task.done = true;
    });
    busySeconds_ += busy.seconds();
    for (std::size_t t = 0; t < tasks.size();) {
        const auto& members = groups_[tasks[t].group];
        std::size_t end = t;
        bool whole = true;
        for (; end < tasks.size() && tasks[end].group == tasks[t].group; ++end) whole = whole && tasks[end].done;
        for (; t < end; ++t) {
            counters_ += tasks[t].counters;
            for (std::size_t m = 0; whole && m < members.size(); ++m) sums_[members[m]].add(tasks[t].sums[m]);
        }
    }
}

}  // namespace luxdeck
