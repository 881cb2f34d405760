#pragma once

#include "engine/core/result.h"
#include "engine/scene/sun_position.h"

#include <optional>
#include <span>
#include <string>

/// The arguments of Radiance's gensky and gendaylit.
namespace luxdeck::gensky {

enum class Kind { Clear, Overcast, Uniform, Intermediate };
enum class PerezInput { None, Parameters, Normal, Lux, Horizontal };

struct Options {
    int month = 1, day = 1;
    double hour = 12;
    bool solarTime = false;
    std::optional<SolarAngles> angles;            ///< given instead of a date
    std::optional<int> year;                      ///< the almanac's sun instead of the simple one
    double latitudeRad = 0.66;                    ///< the programs' own: San Francisco
    double longitudeRad = 2.13, meridianRad = 2.0944;  ///< west positive
    Kind kind = Kind::Clear;
    bool sun = true;
    double groundReflectance = 0.2;
    double turbidity = 2.45;
    std::optional<double> zenithRadiance, horizontalIrradiance;  ///< [W/sr/m^2], [W/m^2]
    std::optional<double> solarRadiance, solarIrradiance;        ///< the latter horizontal
    PerezInput input = PerezInput::None;
    double direct = 0, diffuse = 0;               ///< as `input` means them
    int output = 0;                               ///< gendaylit's -O
};

/// errors  InvalidArgument, Unsupported: program, option, value seen, value expected
Result<Options> readOptions(const std::string& program, std::span<const std::string> words);

/// The sun's place at the options' date.
SolarAngles solarAngles(const Options& options);

}  // namespace luxdeck::gensky
