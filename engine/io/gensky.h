#pragma once

#include "engine/core/result.h"
#include "engine/scene/sky.h"

#include <span>
#include <string>
#include <vector>

namespace luxdeck {

/// What Radiance's gensky or gendaylit make of their arguments: the sky, and in `sky.suns` the sun where there is
/// one, in cd/m^2 (Radiance's numbers times 179), rounded as the programs print them.
///
/// In a Radiance scene the sky lights nothing by itself: a glow modified by skyfunc, on a source, does. For
///     skyfunc glow g ... r g b     g source s ... 0 0 1 180
/// append to Scene::sky.domes a dome {direction, half the angle, 179 * (r, g, b), skyPattern(sky, turn, 179)}
/// (engine/scene/sky_models.h); for the sun, a light on a source of few degrees, append sky.suns.
struct GeneratedDaylight {
    Sky sky;
    std::vector<std::string> warnings;
};

/// program  "gensky" or "gendaylit"
/// words    its arguments
/// errors   InvalidArgument, Unsupported: the option, the value seen, the value expected; `where` is left empty
Result<GeneratedDaylight> generateDaylight(const std::string& program, std::span<const std::string> words);

}  // namespace luxdeck
