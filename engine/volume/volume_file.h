#pragma once

#include "engine/core/result.h"
#include "engine/volume/volume.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck {

/// Writes a volume as a VTK XML file (.vtu, raw appended data) that ParaView and VTK open: its vertices are points, its
/// undivided cells hexahedra, with irradiance in six directions, error and the spheres of radiance as point data; what
/// Luxdeck needs beside is field data, settings as text. Whole or not at all.
///
/// errors  InvalidArgument (folder), OutOfResources (disk)
Result<void> writeVolume(const std::filesystem::path& path, const IrradianceVolume& volume);

/// Reads what writeVolume() wrote.
///
/// errors  FileNotFound, OutOfResources; Parse: not such a file, cut off, or its bytes are not what was written (their hash
///         is in the file), with what was seen and expected
Result<IrradianceVolume> readVolume(const std::filesystem::path& path);

enum class Checksum { Checked, Ignored };  ///< ignored: for fuzzing alone

/// The same from memory; `name` is what messages call it.
Result<IrradianceVolume> parseVolume(std::string_view bytes, const std::filesystem::path& name, Checksum checksum = Checksum::Checked);

/// What differs between the scene that a volume was built of and another: "object desk 3 changed", "luminaire A 2 is new" ...
/// Empty: nothing.
std::vector<std::string> sceneChanges(const IrradianceVolume& volume, const Scene& scene);

/// errors  InvalidArgument naming what changed (the first few of it), when the volume is not of this scene
Result<void> checkVolumeIsOf(const IrradianceVolume& volume, const Scene& scene);

}  // namespace luxdeck
