#pragma once

#include "engine/core/result.h"
#include "engine/transport/radiance_estimator.h"

namespace luxdeck {

/// A material that gives back or lets through this much loses nothing: fractions that should sum to 1 may round
/// below it [-].
inline constexpr float kGivesAllBack = 1 - 1e-6F;

/// The light that a material gives back or lets through, in the channel where that is most, textures taken as they
/// are on average [-].
float mostGivenBack(const Scene& scene, const Material& material);

/// Mean of what surfaces reflect, by area, in the channel where that is most; 0 without surfaces. With it light in a
/// closed room is 1 / (1 - mean) of what it would be without reflections, and an error of a reflectance is multiplied
/// by as much. What is let through counts as gone.
double meanReflectance(const Scene& scene);

/// Light must be lost in time, or there is no answer: in a closed room whose surfaces all reflect everything it grows
/// without bound. Walks at random from every kind of light until one is absorbed or gets out; asks nothing where all
/// materials absorb.
///
/// errors  InvalidArgument: from a light no walk lost anything (names it, and how many reflections were followed)
/// cost    a few milliseconds in scenes with a material that loses nothing
Result<void> checkThatLightIsLost(const TransportScene& scene);

}  // namespace luxdeck
