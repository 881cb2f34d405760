#pragma once

#include "analysis/compare/comparison.h"
#include "engine/algorithms/registry.h"
#include "engine/core/progress.h"
#include "engine/io/project.h"
#include "engine/transport/lit_scene.h"
#include "engine/volume/volume.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace luxdeck {

/// Samples of each bin: of the algorithms' volumes, and of the reference's.
inline constexpr std::uint32_t kPairSamples = 4, kPairReferenceSamples = 32;

/// Takes what is built: the reference's volume as "reference", then each algorithm's by its name.
using TakeVolume = std::function<Result<void>(const std::string& name, std::shared_ptr<const IrradianceVolume> volume)>;

/// Builds the project's volume by each of its compared algorithms and by the reference (`path`): how two algorithms move light
/// differently (Greger 1996, 5.4). What it finds goes into the comparison; cancelled it keeps what is whole.
///
/// errors  those of makeEstimator(), buildVolume() and of `take`
Result<void> compareVolumePairs(const Project& project, const LitScene& lit, const AlgorithmSettings& settings, const TakeVolume& take,
                                const Progress& progress, Comparison& comparison);

/// The same, written into a folder as reference.vtu, NAME.vtu and NAME_difference.vtu (algorithm less reference), to be looked
/// at in ParaView.
///
/// errors  those above, and of writeVolume()
Result<void> compareVolumePairs(const Project& project, const LitScene& lit, const AlgorithmSettings& settings, const std::filesystem::path& folder,
                                const Progress& progress, Comparison& comparison);

}  // namespace luxdeck
