#pragma once

#include "engine/volume/volume_build.h"

#include <cstddef>

namespace luxdeck::gui {

/// What a volume will be, before it is built.
struct VolumeEstimate {
    std::size_t vertices = 0;
    std::size_t bins = 0;
    std::size_t bytes = 0;    ///< without light that is sought beside the bins, which no one knows before
    bool least = false;       ///< cells are divided by light: it may become more
};

/// errors  of volumeLattice()
Result<VolumeEstimate> estimateVolume(const Scene& scene, const VolumeSettings& settings);

}  // namespace luxdeck::gui
