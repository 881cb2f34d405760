#pragma once

#include "engine/core/result.h"
#include "engine/io/rad_stream.h"
#include "engine/io/scene_files.h"

#include <filesystem>
#include <vector>

namespace luxdeck {

/// Reads Radiance scene files in their order as one stream of primitives (docs/radiance.md). The scene has
/// Radiance's primaries and luminance weights; its radiances are luminances (times 179 lm/W).
///
/// errors  FileNotFound, Parse, Unsupported, InvalidArgument, OutOfResources: "file:line: seen, expected"
Result<ScenePart> readRad(const std::vector<std::filesystem::path>& files, const GeometryPlacement& placement,
                          const rad::Limits& limits = {});

/// Radiance's weights of red, green and blue in luminance.
inline constexpr LuminanceWeights kRadianceWeights{0.265, 0.670, 0.065};

}  // namespace luxdeck
