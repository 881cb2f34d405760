#pragma once

#include "engine/transport/radiance_estimator.h"

#include <string>
#include <vector>

namespace luxdeck {

/// Whether light by way of this triangle is met by chance alone: it mirrors or bends light, and is no flat mirror or pane by
/// way of which lights are sought.
bool leftToChance(const TransportScene& scene, std::uint32_t mesh, std::uint32_t triangle);

/// Each surface by way of which lights of the scene are met by chance alone, and these lights: a line for each material, for
/// people. Empty where there is no such surface or no such light.
std::vector<std::string> chanceLightWarnings(const TransportScene& scene);

}  // namespace luxdeck
