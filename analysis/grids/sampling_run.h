#pragma once

#include "analysis/grids/measurement.h"
#include "analysis/grids/neighbours.h"
#include "engine/core/progress.h"
#include "engine/core/stopwatch.h"

#include <optional>
#include <vector>

namespace luxdeck {

/// Spends samples on many targets in parallel, in rounds. What a round adds to one target comes whole or
/// not at all, so that an interruption leaves every target with a valid estimate; results depend on seed
/// and rounds alone, not on the number of threads.
class SamplingRun {
public:
    SamplingRun(const RadianceEstimator& estimator, const LuminanceWeights& weights, std::vector<Target> targets,
                std::uint64_t seed)
        : estimator_(estimator), weights_(weights), targets_(std::move(targets)), groups_(neighbours(targets_, estimator.groupSize())),
          sums_(targets_.size()), seed_(seed) {}

    /// Adds request[i] samples to every replicate of target i (0: none); those of a group that
    /// need any are asked together. Stops early when cancelled or at
    /// the deadline (seconds on the run's clock). Reports after each slice of about a quarter second.
    ///
    /// returns  whether the round was finished
    bool round(const std::vector<std::uint32_t>& request, const Progress& progress, ProgressState& state,
               std::optional<double> deadline);

    [[nodiscard]] const std::vector<PointSums>& sums() const { return sums_; }
    [[nodiscard]] const TransportCounters& counters() const { return counters_; }
    [[nodiscard]] double seconds() const { return clock_.seconds(); }
    /// Paths a second so far; 0 before the first round.
    [[nodiscard]] double pathsPerSecond() const;

private:
    struct Slice {
        std::size_t first, last;  // groups
    };
    void runSlice(const std::vector<std::uint32_t>& request, Slice slice, const Progress& progress,
                  std::optional<double> deadline);

    /// Rate, time left and fraction done, from what was left when the round began (negative: not known).
    void tell(ProgressState& state, double begun, double leftThen, std::optional<double> deadline) const;

    const RadianceEstimator& estimator_;
    LuminanceWeights weights_;
    std::vector<Target> targets_;
    std::vector<std::vector<std::size_t>> groups_;
    std::vector<PointSums> sums_;
    std::uint64_t seed_;
    TransportCounters counters_;
    Stopwatch clock_;
    double busySeconds_ = 0;
};

}  // namespace luxdeck
