#include "analysis/grids/sampling_run.h"

#include "engine/core/parallel.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace luxdeck {

namespace {

constexpr double kSliceSeconds = 0.25;

/// A group's share of a round is split so that even one target keeps all threads busy.
constexpr std::uint32_t kMostPerTask = 64;  // samples of each replicate: 2048 paths

struct Task {
    std::size_t group;
    std::vector<std::size_t> members;   // of the group: those that need these samples
    std::vector<std::uint32_t> firsts;  // of the members
    std::uint32_t count;
    std::vector<PointSums> sums;        // of the members
    TransportCounters counters;
    bool done = false;
};

/// What a group's members need, in steps: all that need any get what the most modest needs, the others go on.
void addTasks(std::size_t group, const std::vector<std::size_t>& all, const std::vector<std::uint32_t>& request,
              const std::vector<PointSums>& sums, std::vector<Task>& tasks) {
    std::uint32_t given = 0;
    while (true) {
        std::vector<std::size_t> members;
        std::uint32_t level = std::numeric_limits<std::uint32_t>::max();
        for (const auto member : all)
            if (request[member] > given) members.push_back(member), level = std::min(level, request[member]);
        if (members.empty()) return;
        const auto most = std::max(4U, kMostPerTask / static_cast<std::uint32_t>(members.size()));
        while (given < level) {
            Task task{group, members, {}, std::min(most, level - given), {}, {}};
            for (const auto member : members) task.firsts.push_back(sums[member].perReplicate + given);
            given += task.count;
            tasks.push_back(std::move(task));
        }
    }
}

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
            for (const auto member : groups_[last]) planned += double{kReplicates} * request[member];
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

void SamplingRun::runSlice(const std::vector<std::uint32_t>& request, Slice slice, const Progress& progress,
                           std::optional<double> deadline) {
    std::vector<Task> tasks;
    for (std::size_t g = slice.first; g < slice.last; ++g) addTasks(g, groups_[g], request, sums_, tasks);
    const Stopwatch busy;
    parallelFor(tasks.size(), [&](std::size_t t) {
        auto& task = tasks[t];
        if (progress.cancelled() || (deadline && seconds() >= *deadline)) return;
        if (task.members.size() == 1)
            task.sums = {measure(estimator_, weights_, targets_[task.members.front()], seed_, task.firsts.front(), task.count, task.counters)};
        else
            task.sums = measureTogether(estimator_, weights_, targets_, task.members, seed_, task.firsts, task.count, task.counters);
        task.done = true;
    });
    busySeconds_ += busy.seconds();
    for (std::size_t t = 0; t < tasks.size();) {
        std::size_t end = t;
        bool whole = true;
        for (; end < tasks.size() && tasks[end].group == tasks[t].group; ++end) whole = whole && tasks[end].done;
        for (; t < end; ++t) {
            counters_ += tasks[t].counters;
            for (std::size_t m = 0; whole && m < tasks[t].members.size(); ++m) sums_[tasks[t].members[m]].add(tasks[t].sums[m]);
        }
    }
}

}  // namespace luxdeck
