#pragma once

#include "analysis/grids/sampling_run.h"
#include "engine/io/project.h"

#include <ctime>

#include <algorithm>
#include <string>
#include <vector>

/// What the benchmarks share: how times are compared on a noisy machine, and the goals they are held to.
namespace luxdeck::bench {

inline double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// What the calling thread has computed for so far [s]: on a shared machine its waiting does not count.
inline double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
/// Wall time: for work that is spread over threads.
inline double wallSeconds() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Seconds that two sides took, run in turn so that both meet the same noise.
struct Contest {
    std::vector<double> first, second;

    /// Median over the pairs of second over first: the speed of the first relative to the second.
    [[nodiscard]] double ratio() const {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < first.size(); ++i) ratios.push_back(second[i] / first[i]);
        return median(std::move(ratios));
    }
};

using Clock = double (*)();

template <class Work>
double secondsOf(Clock clock, Work&& work) {
    const double start = clock();
    work();
    return clock() - start;
}

/// Both sides once to warm up, then `repetitions` pairs; the side that begins changes from pair to pair.
template <class First, class Second>
Contest contest(Clock clock, int repetitions, First&& first, Second&& second) {
    first(), second();
    Contest out;
    for (int i = 0; i < repetitions; ++i) {
        const bool swapped = i % 2 != 0;
        if (swapped) out.second.push_back(secondsOf(clock, second));
        out.first.push_back(secondsOf(clock, first));
        if (!swapped) out.second.push_back(secondsOf(clock, second));
    }
    return out;
}

/// A figure for the table at the end of the run. minimum 0: no goal, told for information.
void record(const std::string& what, double measured, const std::string& unit, double minimum = 0);

/// projects/office, read once. Ends the program when it cannot be read: nothing could be measured.
const Project& office();

/// The sensors of all calculation grids of a project.
std::vector<Target> gridTargets(const Project& project);

}  // namespace luxdeck::bench
