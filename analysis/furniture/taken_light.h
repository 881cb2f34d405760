#pragma once

#include "analysis/furniture/furniture_lighting.h"
#include "analysis/grids/solver.h"
#include "engine/transport/lit_scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace luxdeck {

struct TakenSettings {
    std::uint32_t directions = 512;    // from each grid point
    std::uint32_t lightSamples = 256;  // towards luminaires and sky
    std::uint64_t seed = 1;
};

/// What an object takes from a grid's points, as means over the grid [lx].
struct TakenLight {
    double empty = 0;          // of the room without the object, from the volume
    double direct = 0;         // straight from luminaires and sky, which the object hides
    double indirect = 0;       // from surfaces that it hides
    double returned = 0;       // that its own surfaces give instead

    [[nodiscard]] double furnished() const { return empty - direct - indirect + returned; }
    [[nodiscard]] double taken() const { return direct + indirect - returned; }
};

struct GridTaken {
    std::string name;
    std::vector<TakenLight> points;  // in the grid's order
    TakenLight mean;                 // over points of which the volume knows something
    std::size_t most = 0;            // the point that loses most
    std::size_t unknown = 0;         // points that no vertex of the volume sees: left out of the mean
};

/// Estimates, to first order, what the object takes from the project's grids where lighting.update() put it: for each
/// point the light that would come from where the object now is. Light that is reflected once between object and room
/// before it reaches a point, and all that follows, is left out; so is what panes of the object absorb.
///
/// lit      the room without the object, of which the volume is
/// errors   InvalidArgument: a grid that cannot be laid out
Result<std::vector<GridTaken>> estimateTaken(const Project& project, const LitScene& lit, const FurnitureLighting& lighting, const TakenSettings& settings = {});

/// Empty against furnished, both solved.
struct GridDifference {
    std::string name;
    JudgedInterval emptyMean, furnishedMean, emptyMinimum, furnishedMinimum;  // [lx]
    Interval takenMean;                                                      // empty - furnished [lx]
};
struct ExactTaken {
    SolveResult empty, furnished;
    std::vector<GridDifference> grids;
};

/// Solves the project's grids without and with the object.
///
/// project    its scene is that without the object
/// furnished  withObjectAt()
/// errors     of solve()
Result<ExactTaken> solveTaken(const Project& project, const LitScene& lit, Scene furnished, const SolveSettings& settings, const Progress& progress);

/// The illuminance of an object's vertices in the room that holds it, by an unbiased estimator: what the volume's answer is
/// compared with.
struct FullSolution {
    std::vector<std::uint32_t> vertices;  // of the object, evenly chosen by number
    std::vector<Interval> lux;            // of their luminance [lx]
    double rms = 0;                       // of the volume's answers minus these, their own noise taken off [lx]
    double relativeRms = 0;               // over the mean of these [-]
    double bias = 0;                      // mean of the volume's minus these [lx]
    double inside = 0;                    // part of these that lie in the volume's own intervals, widened by their noise
};

/// furnished  the scene with the object at the pose of the last lighting.update(); vertices that the volume knows nothing
///            of are passed over
/// samples    paths for each vertex
FullSolution solveVertices(const LitScene& furnished, const RadianceEstimator& estimator, const FurnitureLighting& lighting, std::size_t vertices,
                           std::uint32_t samples, std::uint64_t seed, const Progress& progress);

}  // namespace luxdeck
