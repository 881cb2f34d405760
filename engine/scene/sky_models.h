#pragma once

#include "engine/core/result.h"
#include "engine/scene/sky.h"

#include <array>
#include <memory>

namespace luxdeck {

/// The CIE clear sky with a zenith of luminance 1, turned to the sun.
Sky cieClearSky(const Vec3& sunDirection);
/// The CIE intermediate sky likewise, in Radiance's form.
Sky cieIntermediateSky(const Vec3& sunDirection);
/// One of the 15 skies of CIE S 011 / ISO 15469, type 1 .. 15, likewise.
Sky cieGeneralSky(int type, const Vec3& sunDirection);

/// What the weather says to Perez's model.
struct PerezWeather {
    double sunZenithRad = 0;
    double dayOfYear = 1;             ///< 1 .. 366
    double directNormalWm2 = 0;       ///< >= 0
    double diffuseHorizontalWm2 = 0;  ///< > 0
    double dewPointC = 10.97;         ///< 2 cm of precipitable water
};

struct PerezParameters {
    double clearness = 1;             ///< epsilon, 1 .. < 12.01
    double brightness = 0.1;          ///< delta, 0.01 .. 0.6
};

struct PerezEfficacy {
    double diffuse = 0;               ///< of the diffuse horizontal irradiance [lm/W]
    double direct = 0;                ///< of the direct normal irradiance [lm/W], >= 0
};

/// The parameters of the weather, clamped to the model's range.
PerezParameters perezParameters(const PerezWeather& weather);
/// The weather that has these parameters, without the dew point.
PerezWeather perezWeather(const PerezParameters& parameters, double sunZenithRad, double dayOfYear);
PerezEfficacy perezEfficacy(const PerezParameters& parameters, double sunZenithRad, double dewPointC);
/// The factors of the luminance distribution. Source: Perez, Seals & Michalsky 1993, with the erratum.
SkyShape perezShape(const PerezParameters& parameters, double sunZenithRad);
/// Perez's sky with a zenith of luminance 1.
Sky perezSky(const PerezParameters& parameters, const Vec3& sunDirection);

/// The sky scaled to a horizontal illuminance, its suns left as they are; the ground is lit by both.
Sky scaledToHorizontal(Sky sky, double lux, const LuminanceWeights& weights = kRec709);

/// A sky's luminance over `efficacy`, turned by a rotation, as a pattern: the skyfunc of gensky, efficacy 179.
std::shared_ptr<const Pattern> skyPattern(const Sky& sky, const Matrix4d& turn, double efficacy);

}  // namespace luxdeck
