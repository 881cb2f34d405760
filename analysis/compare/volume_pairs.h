#pragma once

#include "engine/algorithms/registry.h"
#include "engine/core/progress.h"
#include "engine/io/project.h"
#include "engine/transport/lit_scene.h"
#include "engine/volume/volume_diff.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace luxdeck {

/// One algorithm's volume beside the reference's.
struct VolumePair {
    std::string algorithm;
    double setupSeconds = 0, seconds = 0;
    FieldDifference total, direct, indirect;  // of the reference (first) and the algorithm (second), irradiance
};

struct VolumePairs {
    std::string referenceAlgorithm;
    double referenceSeconds = 0;
    double referenceError95 = 0;   // of the irradiance at its vertices, rms, relative
    std::vector<VolumePair> pairs;
    bool complete = true;
};

/// Samples of each bin: of the algorithms' volumes, and of the reference's.
inline constexpr std::uint32_t kPairSamples = 4, kPairReferenceSamples = 32;

/// Builds the project's volume by each algorithm and by the reference (`path`), and writes into a folder reference.vtu,
/// NAME.vtu and NAME_difference.vtu (algorithm less reference), to be looked at in ParaView: how two algorithms move light
/// differently (Greger 1996, 5.4). Cancelled it comes back with what is whole.
///
/// errors  those of makeEstimator(), buildVolume() and writeVolume()
Result<VolumePairs> compareVolumePairs(const Project& project, const LitScene& lit, const std::vector<std::string>& algorithms,
                                       const AlgorithmSettings& settings, std::uint64_t seed, const std::filesystem::path& folder, const Progress& progress);

}  // namespace luxdeck
