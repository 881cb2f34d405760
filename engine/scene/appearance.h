#pragma once

#include "engine/core/rgb.h"
#include "engine/scene/pattern.h"
#include "engine/scene/scene.h"

namespace luxdeck {

/// The part of a surface that is there at a point, by the alpha of its texture: 0 a hole, 1 none [-].
float coverage(const Scene& scene, const Material& material, const Vec2& uv);

/// What a material emits against the ray, texture and pattern included, whichever side is asked [cd/m^2]; NaN
/// where the pattern has no value. Holes are not counted.
Rgb emittedRadiance(const Scene& scene, const Material& material, const PatternPoint& at);

/// Mean luminance of an emitting triangle over its points and directions, roughly, and never zero: for choosing
/// how often it is asked for light [cd/m^2].
float meanEmission(const Scene& scene, const Mesh& mesh, std::uint32_t triangle);

}  // namespace luxdeck
