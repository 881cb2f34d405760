#pragma once

#include "engine/core/progress.h"
#include "engine/core/statistics.h"
#include "engine/transport/radiance_estimator.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace luxdeck {

/// What a row must agree with.
struct Cie171Reference {
    double value = 0;
    double error = 0;      // of the quadrature that made it, absolute; 0: closed form
    std::string note;      // what the reader should also know; may be empty
};

/// One figure of a case: a weighted sum of illuminances.
struct Cie171Quantity {
    std::string point;                  // "floor, 1 m beside the lamp"
    std::string unit;                   // "lx", "lm", "%", "-"
    std::vector<SensorQuery> sensors;
    std::vector<double> weights;        // #sensors, from lx to the unit
    bool reflectedAlone = false;        // of the indirect part of the illuminance
    Cie171Reference reference;
};

/// A scene of the analytical cases of CIE 171:2006 with what is asked of it.
struct Cie171Case {
    std::string number;                 // of CIE 171:2006, "5.2"
    std::string subject;
    std::string configuration;          // of this scene among the case's
    bool straight = false;              // without reflections: by `direct` too
    std::function<Result<Scene>()> scene;
    std::vector<Cie171Quantity> quantities;
};

/// Every case of section 5. Section 4, measured rooms, needs a data set that is not in our hands.
std::vector<Cie171Case> cie171Cases();

enum class Cie171Verdict {
    Within,
    Outside,   // or no value at all
    TooNoisy   // the interval is wider than kCie171Noise: nothing is shown
};

/// "within", "outside", "too noisy".
const char* verdictText(Cie171Verdict verdict);

struct Cie171Row {
    std::string number, subject, configuration, algorithm;
    std::string point, unit;
    Interval value;                     // in `unit`
    Cie171Reference reference;
    Cie171Verdict verdict = Cie171Verdict::Outside;
    std::string refused;                // the message, when the scene was

    /// Of the value from the reference, over the reference.
    [[nodiscard]] double deviation() const { return value.value / reference.value - 1; }
};

/// A row is within when it deviates by no more than this part of the reference, or by kCie171Sigmas standard errors.
inline constexpr double kCie171Tolerance = 0.005;
inline constexpr double kCie171Sigmas = 3;
/// The 95 % interval that is aimed at, over the reference: the tolerance is four standard errors then, and a new seed fails
/// a row with chance 3e-4 (Student's t, 31 degrees of freedom). Rows that would take too long stay wider, where three
/// standard errors decide, with 5e-3; above four times this a row is too noisy to show anything.
inline constexpr double kCie171Precision = 0.0025;
inline constexpr double kCie171Noise = 4 * kCie171Precision;

/// The rows of one case by one algorithm. Never fails: what goes wrong is a verdict.
std::vector<Cie171Row> runCie171Case(const Cie171Case& one, const std::string& algorithm, std::uint64_t seed, const Progress& progress);

/// Every case (or the one of a number, none when there is no such) by `path`, those without reflections by `direct` too, or as far as it came when cancelled.
std::vector<Cie171Row> runCie171(std::uint64_t seed, const Progress& progress, const std::string& number = {});

}  // namespace luxdeck
