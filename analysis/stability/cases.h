#pragma once

#include "analysis/stability/stability.h"
#include "engine/scene/scene_builder.h"

#include <string>
#include <utility>
#include <vector>

namespace luxdeck::stability {

using Cases = std::vector<StabilityCase>;

void addReflectionCases(Cases& cases);
void addLightCases(Cases& cases);
void addGeometryCases(Cases& cases);
void addInputCases(Cases& cases);
void addSensorCases(Cases& cases);
void addGlassCases(Cases& cases);

inline Criterion is(double lux, double slackLux, std::string why) { return {lux, slackLux, {}, std::move(why)}; }
inline Criterion isSane(std::string why) { return {{}, 0, {}, std::move(why)}; }
inline Criterion isRefused(std::string words) { return {{}, 0, std::move(words), "no answer would be right"}; }

inline SensorQuery facing(Vec3 position, Vec3 normal) { return {position, normal.normalized(), SensorKind::Planar, {}}; }

/// Of the radiance of furnaces, whose walls all emit [cd/m^2].
inline constexpr double kFurnaceCdM2 = 10;
/// Illuminance anywhere in a furnace: the sum of all reflections; the slack is float's rounding of up to 1000 of them.
inline Criterion furnaceTotal(double reflectance) {
    const double lux = kPiD * kFurnaceCdM2 / (1 - reflectance);
    return is(lux, 1e-4 * lux, "closed form pi L / (1 - rho)");
}
/// The same without reflections.
inline Criterion furnaceStraight() { return is(kPiD * kFurnaceCdM2, 1e-4 * kPiD * kFurnaceCdM2, "closed form pi L"); }

/// A cube of side 4 m whose walls emit, at a corner.
SceneBuilder& furnace(SceneBuilder& builder, float reflectance, Vec3 corner = {0, 0, 0});

/// Of the lamp in integratingSphere() [lm].
inline constexpr double kSphereLumens = 1000;
/// A sphere of radius 1 m and reflectance 0.5 about a lamp, in lengths that are stored in `metresPerUnit`.
Scene integratingSphere(double metresPerUnit, LuminousOpening opening = {}, double lumens = kSphereLumens);
/// On its wall.
SensorQuery sphereSensor();
Criterion sphereTotal(double lumens = kSphereLumens);
Criterion sphereStraight(double lumens = kSphereLumens);

}  // namespace luxdeck::stability
