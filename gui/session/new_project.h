#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <string>

namespace luxdeck::gui {

/// The text of a first project of a model: its geometry, a workplane 0.75 m above its floor with the spacing of EN 12464-1, a
/// view from a corner, an irradiance volume over the whole. Luminaires are the designer's.
///
/// geometry  .glb, .gltf or .obj, in or below `folder` (where the project will lie), or anywhere: then by its full path
/// errors    of reading the model; InvalidArgument: it has no extent
Result<std::string> firstProjectText(const std::filesystem::path& geometry, const std::filesystem::path& folder, const std::string& name);

}  // namespace luxdeck::gui
