#pragma once

#include "engine/algorithms/registry.h"
#include "engine/transport/lit_scene.h"

#include <cstddef>
#include <memory>
#include <string>

namespace luxdeck {

/// A clock that run times are read from [s].
using RunClock = double (*)();
double wallSeconds();
/// Of all threads together: on a machine that others use too, waiting does not count. Two cores at work make two seconds a second.
double coreSeconds();

/// An algorithm made ready, and what that cost.
struct Prepared {
    std::unique_ptr<RadianceEstimator> estimator;
    double seconds = 0;
};

/// errors  those of makeEstimator()
Result<Prepared> prepare(const std::string& algorithm, const LitScene& lit, const AlgorithmSettings& settings, RunClock clock);

/// How the time of an algorithm's preparation grows with its effort.
struct SetupCost {
    double fixedSeconds = 0;
    double secondsPerEffort = 0;   // 0: nothing is prepared that effort would change

    /// The effort whose preparation takes so long, within the limits that algorithms accept; 1 where it changes nothing.
    [[nodiscard]] double effortFor(double seconds) const;
    [[nodiscard]] double secondsOf(double effort) const { return fixedSeconds + secondsPerEffort * effort; }
};

/// Measured at low effort first, then at more until it takes long enough to be told from noise.
///
/// settings  without an effort
/// errors    those of makeEstimator()
Result<SetupCost> measureSetup(const std::string& algorithm, const LitScene& lit, AlgorithmSettings settings, RunClock clock);

/// The largest memory that the process has had since resetPeak() [bytes]; 0 where the system does not tell (only Linux does).
std::size_t peakBytes();
void resetPeak();

}  // namespace luxdeck
