#pragma once

#include "analysis/compare/comparison.h"
#include "engine/core/progress.h"
#include "engine/io/project.h"
#include "engine/transport/lit_scene.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck {

struct CompareSettings {
    std::vector<std::string> algorithms;       // empty: all that are registered
    AlgorithmSettings algorithmSettings;       // effort and seed are set by the comparison
    std::uint64_t seed = 1;
    double budgetSeconds = 4;                  // of the largest run; each rung below has half
    std::optional<std::uint32_t> samples;      // paths for each point or pixel of the largest run, instead: nothing is measured by the clock
    bool coreTime = false;                     // all times, the budgets' too, are seconds of all cores together: others' work on the machine does not count
    int rungs = 5;                             // 2 .. 12
    int repetitions = 4;                       // 3 .. 64
    bool grids = true;
    std::vector<std::string> views;            // names; pictures of these
    int pictureHeight = 120;                   // pixels
    std::string referenceAlgorithm = "shared";
    double referenceError = 0.01;              // rms over the points of the 95 % half-width
    double pictureReferenceError = 0.1;        // the same over the pixels
    std::filesystem::path referenceFile;       // kept there and reused; empty: not kept
    bool renewReference = false;               // a file of another scene is replaced instead of refused
};

/// The values behind a reference or a run, for whoever wants to see more than figures.
struct ComparedValues {
    std::string subject;
    std::string algorithm;                     // of a run; empty: the reference
    int rung = 0;                              // of a run
    int columns = 0, rows = 0;                 // of a picture [pixels]; 0: points of the grids
    std::vector<double> values;                // mean of the repetitions (of the reference's parts) [lx; cd/m^2 of pictures]
    std::vector<ErrorMap> maps;                // of that mean, one for each grid or the picture; none of the reference
};

/// Hears of every reference and run as it is finished, with all that was found so far, summarized and marked incomplete.
using AfterRun = std::function<void(const Comparison& soFar, const ComparedValues& last)>;

/// Runs algorithms over a ladder of budgets against a reference. Rung after rung, in each all algorithms in turn, so that
/// a machine's moods meet all of them and what an interruption leaves is comparable. Where an algorithm prepares something,
/// its effort is such that this takes about half of the budget. Values depend on the seed and the numbers of samples (and effort) alone.
///
/// lit       made of project.scene
/// afterRun  called by the calling thread; may be empty
/// returns   incomplete when cancelled, with what there is: whole runs only
/// errors    InvalidArgument: no such algorithm or view, nothing to compare on, a setting out of range, a reference file of another scene,
///           no algorithm that this scene can be lit by; Cancelled: before the first reference; those of reading and writing the reference file
Result<Comparison> compare(const Project& project, const LitScene& lit, const CompareSettings& settings, const Progress& progress,
                           const AfterRun& afterRun = {});

/// The project's views of these names.
///
/// names   "all" alone: every view
/// errors  InvalidArgument, listing the views there are
Result<std::vector<View>> viewsNamed(const Project& project, const std::vector<std::string>& names);

}  // namespace luxdeck
