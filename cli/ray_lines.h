#pragma once

#include "engine/scene/scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace luxdeck::cli {

/// A place and a direction, as a line of six numbers gives them.
struct RayLine {
    Vec3 position{0, 0, 0};    // re-based [m]
    Vec3 direction{0, 0, 1};   // unit
};

/// Beyond this, single precision could not tell a point from its neighbours.
inline constexpr double kFarthestM = 1e8;

/// "x y z dx dy dz", blanks or commas between; empty: not six numbers in their range, or a direction without length.
std::optional<RayLine> parseRayLine(const std::string& line, const Scene& scene);
/// The same where only the origin of the coordinates is known.
std::optional<RayLine> parseRayLine(const std::string& line, const Vec3d& origin);

bool isBlank(const std::string& line);

/// Says on stderr what a bad line of stdin was; lines count from 1.
void complainOfRayLine(const std::string& line, std::uint64_t number);

}  // namespace luxdeck::cli
