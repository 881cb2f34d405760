#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck {

/// A place and the picture of all that is seen from there.
struct PanoramaNode {
    Vec3d position{0, 0, 0};         // [m]
    std::filesystem::path picture;   // EXR or RGBE by longitude and latitude, its middle column facing +y
    double lowestDeg = -90;          // of latitude that the picture covers, at its lower edge
    double highestDeg = 90;          // at its upper edge
};

struct PanoramaNodes {
    std::vector<PanoramaNode> nodes;
    double defaultCdM2 = 0;          // of directions that a picture does not cover, or has no value for
};

/// Reads a TOML file with `default` [cd/m^2] and a [[node]] of `position`, `picture` and, where the picture does not show
/// all, `latitude = [low, high]` in degrees, for each picture. Names of pictures are relative to the file.
///
/// errors  FileNotFound, Parse, InvalidArgument, at file:line
Result<PanoramaNodes> readPanoramaNodes(const std::filesystem::path& file);
Result<PanoramaNodes> parsePanoramaNodes(std::string_view bytes, const std::filesystem::path& name);

}  // namespace luxdeck
