#pragma once

#include "engine/core/result.h"
#include "engine/volume/volume.h"

#include <string>
#include <string_view>

namespace luxdeck {

/// The settings as JSON text: what a build is recognised by.
std::string settingsText(const VolumeSettings& settings);

/// Everything of a volume but its arrays, as JSON text.
std::string headerText(const IrradianceVolume& volume);

/// The shape that a header promises; arrays are checked against it.
struct VolumeShape {
    Box3 bounds;
    std::array<int, 3> cells{1, 1, 1};
    int split = 2, depth = 0;
};

/// Fills all of `volume` but lattice and arrays.
///
/// errors  Parse: what is missing or out of range, by its key
Result<VolumeShape> readHeader(std::string_view text, const std::string& name, IrradianceVolume& volume);

}  // namespace luxdeck
