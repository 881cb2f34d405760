#pragma once

#include "analysis/compare/error_statistics.h"
#include "engine/core/vec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck {

/// What the values of one subject were held against.
struct ComparedReference {
    std::string subject;           // "grids" or a view's name
    bool picture = false;
    int width = 0, height = 0;     // of a picture [pixels]
    std::uint64_t values = 0;      // points or pixels
    std::string algorithm;
    double relativeError = 0;      // rms over the values of the 95 % half-width over the scale
    double asked = 0;              // what was asked for; more than this: interrupted
    std::uint64_t samples = 0;     // for each point or pixel
    double seconds = 0;
    bool reused = false;           // it was read from a file
};

struct ComparedAlgorithm {
    std::string name;
    double claimedBias = 0;        // as registered, relative; 0: unbiased
    bool interreflection = true;   // claims indirect light
    std::string refused;           // why it could not be made for this scene; empty: it was
};

/// One algorithm with one budget on one subject, repeated with independent seeds.
struct ComparedRun {
    std::string subject, algorithm;
    int rung = 0;                  // from 0, the smallest budget
    double budgetSeconds = 0;      // asked for; 0: numbers of samples were given instead
    double seconds = 0;            // what it took, set-up included: median of the repetitions
    double setupSeconds = 0;       // likewise of the preparation
    std::uint64_t samples = 0;     // for each point or pixel
    double effort = 1;             // of the preparation
    std::uint64_t preparedBytes = 0;  // memory of what was prepared, as the algorithm tells
    std::uint64_t peakBytes = 0;   // of the whole process during the run, the scene included; 0: the system does not tell
    std::uint64_t rejected = 0;    // samples that were not finite or negative, of all repetitions
    std::optional<double> rms;     // relative; none: below what the reference can tell
    double rmsCi95 = 0;
    double rmsAtMost = 0;          // upper end of its interval, or the reference's own error
    std::optional<double> bias;    // rms of what repetition does not cure; none: not told from nothing
    double biasCi95 = 0;
    double meanError = 0, meanErrorCi95 = 0;  // signed
    double max = 0, p99 = 0;       // means over the repetitions
};

struct ComparedSlope {
    std::string subject, algorithm;
    double slope = 0, ci95 = 0;    // of ln(rms) over ln(seconds)
    int runs = 0;                  // that it is from
};

struct ComparedTime {
    std::string subject, algorithm;
    double error = 0;              // 0.1, 0.05, 0.02, 0.01
    TimeTo time;
};

struct ComparedPlace {
    std::string subject, algorithm;
    int place = 1;                 // equal places: not told apart
    double seconds = 0;            // all are judged at this time
    double rms = 0;
};

/// Where an algorithm is furthest from the truth at its largest budget.
struct WorstValue {
    std::string subject, algorithm;
    std::string grid;              // empty: a pixel
    Vec3d position{0, 0, 0};       // of a point [m]
    int column = 0, row = 0;
    double reference = 0, referenceCi95 = 0;
    double value = 0;              // mean of the repetitions
    double error = 0;              // (value - reference) / scale
};

/// A calculation grid, and where its points are.
struct ComparedGrid {
    std::string name;
    int columns = 0, rows = 0;     // free points are one row
    std::vector<double> x, y, z;   // of the points, rows from v = 0 [m], user coordinates
};

/// Signed errors of every point or pixel at the largest budget, of the mean of the repetitions.
struct ErrorMap {
    std::string subject, algorithm;
    std::string grid;              // empty: the picture
    int columns = 0, rows = 0;
    std::vector<double> errors;    // (value - reference) / scale
};

/// One part of the light of an algorithm's irradiance volume against the reference's, over all directions of all vertices.
struct ComparedVolume {
    std::string algorithm;
    std::string part;              // "total", "direct", "indirect"
    double seconds = 0;            // to build, preparation included
    double rms = 0, p99 = 0, max = 0;  // relative to the reference's rms irradiance
    double noise = 0;              // what the noise of both explains of rms
    double meanLux = 0, referenceMeanLux = 0;
};

/// What `compare` found.
struct Comparison {
    std::string project;
    bool complete = true;
    std::uint64_t seed = 0;
    int threads = 0, repetitions = 0;
    double seconds = 0;            // of all
    bool coreTime = false;         // run times are seconds of all cores together, else of the clock on the wall
    std::vector<ComparedAlgorithm> algorithms;
    std::vector<ComparedReference> reference;
    std::vector<ComparedGrid> grids;
    std::vector<ComparedRun> runs;
    std::vector<ComparedSlope> slopes;
    std::vector<ComparedTime> timeTo;
    std::vector<ComparedPlace> order;
    std::vector<WorstValue> worst;
    std::vector<ErrorMap> maps;
    std::vector<ComparedVolume> volumes;  // when they were asked for
    std::vector<std::string> warnings;
    std::string sceneHash, projectHash, version;
};

/// The runs of one algorithm on one subject whose error could be told, by increasing time.
std::vector<CurvePoint> curveOf(const Comparison& comparison, const std::string& subject, const std::string& algorithm);

/// Fills slopes, timeTo and order from the runs.
void summarize(Comparison& comparison);

}  // namespace luxdeck
