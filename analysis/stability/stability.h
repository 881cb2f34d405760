#pragma once

#include "engine/algorithms/registry.h"
#include "engine/core/progress.h"
#include "engine/core/statistics.h"
#include "engine/transport/radiance_estimator.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck {

/// What must come out of a case.
struct Criterion {
    std::optional<double> lux;  // none: finite and not negative, whatever it is
    double slackLux = 0;        // that the scene or rounding may differ by, beside the noise
    std::string refusal;        // not empty: refused, with these words in the message
    std::string why;            // where value and slack are from
};

/// A scene that breaks careless programs, and the light in it by other means.
struct StabilityCase {
    std::string name;                       // "furnace 0.99"
    std::function<Result<Scene>()> scene;
    std::vector<SensorQuery> sensors;       // what is judged is their mean
    Criterion exact;                        // of algorithms with interreflection
    Criterion straight;                     // of those without
    double precision = 0.02;                // the 95 % interval is at most this part of the value
    std::uint32_t mostPaths = 1U << 16;     // for a sensor
};

/// Every case; the table in the report and the tests are these.
const std::vector<StabilityCase>& stabilityCases();

enum class StabilityVerdict {
    Met,
    Missed,    // another value, or none where one was expected
    TooNoisy,  // the interval is wider than the case allows
    KnownLimit // missed or too noisy, as the algorithm's card says it must be
};

/// "met", "missed", "too noisy", "known limit".
const char* verdictText(StabilityVerdict verdict);

/// One case by one algorithm.
struct StabilityResult {
    std::string name;
    std::string algorithm;
    StabilityVerdict verdict = StabilityVerdict::Missed;
    Interval lux;                    // [lx]; of a refusal 0
    Criterion expected;
    std::string refused;             // with which message
    TransportCounters counters;
    double seconds = 0;

    [[nodiscard]] double truncatedFraction() const {
        return counters.paths > 0 ? counters.truncatedWeight / static_cast<double>(counters.paths) : 0;
    }
};

/// Values count as met within this many standard errors, the slack and what the algorithm says of its bias. False alarms: 2e-4 a case (Student's t, 31 degrees of freedom).
inline constexpr double kStabilitySigmas = 4;

/// Never fails: what goes wrong is a verdict.
StabilityResult runStabilityCase(const StabilityCase& one, const Algorithm& algorithm, std::uint64_t seed, const Progress& progress);

/// Every case by every registered algorithm, or by the one of this name; as far as it came when cancelled.
std::vector<StabilityResult> runStability(std::uint64_t seed, const Progress& progress, const std::string& algorithm = {});

}  // namespace luxdeck
