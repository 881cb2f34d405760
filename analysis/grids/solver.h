#pragma once

#include "analysis/grids/solve_result.h"
#include "engine/core/progress.h"
#include "engine/transport/lit_scene.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace luxdeck {

struct SolveSettings {
    std::string algorithm = "path";
    AlgorithmSettings algorithmSettings;
    std::uint64_t seed = 1;
    double targetError = 0.02;               // relative 95 % half-width of every number; 0: until the time is up
    std::optional<double> timeSeconds;       // budget; none: until the target is reached
    std::optional<std::uint32_t> samples;    // exactly so many paths for each point instead
    bool byLuminaire = false;                // keep the light of each luminaire apart (SolveResult::layers)
};

/// Points whose illuminance is far below their grid's mean count relative to this part of the mean: the
/// error of a dark corner is judged on the scale that its grid is judged on.
inline constexpr double kDarkPoint = 0.1;

/// Illuminance on every calculation grid of a project, with intervals and verdicts. Samples are spent in
/// rounds that at most double a point's samples, where the error is largest relative to the target, until
/// every point, Ēm, Emin and Uo is known to the target or the time is up. Cancelling keeps what there is,
/// marked incomplete.
///
/// lit        made of project.scene
/// afterRound called on the calling thread with the grids and the trace so far; may be empty
/// errors     InvalidArgument: no such algorithm, a setting out of range, a grid that cannot be laid out, an algorithm
///            that does not know where light comes from (byLuminaire), or more layers than memory should hold,
///            nothing to solve
Result<SolveResult> solve(const Project& project, const LitScene& lit, const SolveSettings& settings,
                          const Progress& progress, const std::function<void(const SolveResult&)>& afterRound = {});

}  // namespace luxdeck
