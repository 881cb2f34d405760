#include "analysis/compare/effort.h"

#include <ctime>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>

namespace luxdeck {

namespace {

constexpr double kLeastEffort = 1e-3, kMostEffort = 1e3;  // what AlgorithmSettings allows
constexpr double kFirstEffort = 0.01;
constexpr double kStep = 4;
constexpr double kEnoughSeconds = 0.1;    // to be told from noise
constexpr double kNothingSeconds = 0.01;  // at effort 1: nothing worth half a budget is prepared

}  // namespace

double wallSeconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double coreSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Result<Prepared> prepare(const std::string& algorithm, const LitScene& lit, const AlgorithmSettings& settings, RunClock clock) {
    const double begun = clock();
    auto estimator = makeEstimator(algorithm, lit.transport(), settings);
    if (!estimator) return estimator.error();
    return Prepared{*std::move(estimator), clock() - begun};
}

double SetupCost::effortFor(double seconds) const {
    if (!(secondsPerEffort > 0)) return 1;
    return std::clamp((seconds - fixedSeconds) / secondsPerEffort, kLeastEffort, kMostEffort);
}

Result<SetupCost> measureSetup(const std::string& algorithm, const LitScene& lit, AlgorithmSettings settings, RunClock clock) {
    double first = -1;
    for (double effort = kFirstEffort;; effort *= kStep) {
        settings.effort = effort;
        const auto made = prepare(algorithm, lit, settings, clock);
        if (!made) return made.error();
        if (first < 0) first = made->seconds;
        const double grown = made->seconds - first;
        if (effort >= 1 && made->seconds < kNothingSeconds) return SetupCost{first, 0};
        if (grown >= kEnoughSeconds && grown > 0.5 * first) {
            const double slope = grown / (effort - kFirstEffort);
            return SetupCost{std::max(0.0, first - slope * kFirstEffort), slope};
        }
        if (effort * kStep > kMostEffort || (effort >= 1 && grown < 0.2 * first)) return SetupCost{made->seconds, 0};
    }
}

std::size_t peakBytes() {
    std::ifstream status("/proc/self/status");
    for (std::string key; status >> key; status.ignore(1000, '\n'))
        if (key == "VmHWM:") {
            std::size_t kilobytes = 0;
            status >> kilobytes;
            return kilobytes * 1024;
        }
    return 0;
}

void resetPeak() { std::ofstream("/proc/self/clear_refs") << "5"; }

}  // namespace luxdeck
