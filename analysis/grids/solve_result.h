#pragma once

#include "engine/core/statistics.h"
#include "engine/core/vec.h"
#include "engine/io/project.h"
#include "engine/scene/needs.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck {

enum class Verdict { None, Met, NotMet, Undecided };  ///< None: nothing is required

/// "met", "not met", "undecided", "".
const char* verdictText(Verdict verdict);

/// Met when the whole interval is at or above the limit, not met when it is wholly below, else undecided.
Verdict judge(const Interval& value, std::optional<double> required);

/// Illuminance at one point.
struct PointResult {
    Vec3d position;            // [m], user coordinates
    Vec3d normal;              // unit; of a cylindrical sensor: the vertical axis
    Interval total;            // [lx]
    Interval direct;           // [lx] straight from luminaires and sky (through panes)
    Interval indirect;         // [lx] after one reflection or more
    std::uint64_t samples = 0;
    bool insideSolid = false;  // most of what it sees at once is back faces or nothing: look at the plan
};

/// A statistic with its requirement.
struct JudgedInterval {
    Interval interval;
    std::optional<double> required;
    Verdict verdict = Verdict::None;
};

struct GridResult {
    std::string name;
    GridKind kind = GridKind::Planar;
    int columns = 0;           // points along u and v; 0 for free points
    int rows = 0;
    double spacingU = 0;       // [m]
    double spacingV = 0;
    double borderM = 0;
    Vec3d origin{0, 0, 0}, u{0, 0, 0}, v{0, 0, 0};  // of the surface that was divided, after the border was taken off [m]
    std::vector<PointResult> points;  // rows from v = 0, columns from u = 0
    JudgedInterval mean;       // Ēm [lx]
    JudgedInterval minimum;    // Emin [lx]
    JudgedInterval uniformity; // Uo = Emin / Ēm [-]
    double maximumLux = 0;
    std::vector<Requirement> requirements;
};

/// One entry of error against run time: the state after a pass.
struct ErrorAtTime {
    double seconds = 0;
    double relativeError = 0;  // the largest 95 % half-width over value among the asked-for statistics
    double rmsPointError = 0;  // root mean square of the points' relative half-widths
    std::uint64_t samples = 0;
};

/// How well posed a solve was (analysis/grids/condition.h says when a figure is bad, and why).
struct Condition {
    double meanReflectance = 0;      // of all surfaces by area [-]
    double amplification = 1;        // 1 / (1 - mean reflectance): of light by reflections, and of errors of reflectances
    double effectiveReplicates = 0;  // of the worst point: how many of its replicates carry the value, 1 .. kReplicates
};

struct LayeredSums;

/// What `solve` found: `solve --json` and the report are this.
struct SolveResult {
    std::string project;       // name
    bool complete = true;      // false: interrupted, or numbers are withheld
    bool targetReached = true; // false: the time ran out before the target error
    double targetError = 0;    // relative; 0: none was asked for
    double seconds = 0;        // of solving
    double setupSeconds = 0;   // loading, building, what the algorithm prepares
    double predictedSeconds = 0;  // as told after the first passes
    std::uint64_t samples = 0; // paths
    std::uint64_t rays = 0;
    std::string algorithm;
    double ambientLux = 0;     // constant ambient term, printed when not zero
    std::uint64_t seed = 0;
    int threads = 0;
    std::vector<GridResult> grids;
    std::vector<ErrorAtTime> trace;
    std::vector<LeftOut> leftOut;
    std::vector<std::string> warnings;
    double truncatedFraction = 0;   // of the energy that Russian roulette's depth cap cut off, upper bound
    Condition condition;
    std::uint64_t rejectedSamples = 0;  // of which a part is missing: NaN or negative; counted
    std::uint64_t withheldPoints = 0;   // whose numbers are withheld, since too many of their samples are such
    std::string sceneHash, projectHash;
    std::string version;       // of luxdeck
    std::string kernel;        // "Embree 3.13.5"
    std::shared_ptr<const LayeredSums> layers;  // of a solve by luminaire; else null
};

}  // namespace luxdeck
