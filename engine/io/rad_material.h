#pragma once

#include "engine/core/result.h"
#include "engine/io/rad_primitive.h"
#include "engine/io/warning_list.h"
#include "engine/scene/material.h"
#include "engine/scene/pattern.h"

#include <memory>
#include <string_view>

namespace luxdeck::rad {

/// Radiance's luminous efficacy: its radiance becomes luminance by it, once, here [lm/W].
inline constexpr double kLumensPerWatt = 179;

/// plastic, light, glass ...: what ends a chain of modifiers.
bool isMaterial(std::string_view type);
/// light, glow, spotlight, illum.
bool isEmitter(std::string_view type);

/// A material as the scene has it, and what restricts its emission to a cone (spotlight; else null).
struct MappedMaterial {
    Material material;
    std::shared_ptr<const Pattern> cone;
};

/// The nearest of the scene's materials; docs/radiance.md has the table. What is lost is told in `warnings`.
///
/// metresPerUnit  of the file: absorption is by length
/// turn           from the file's axes to the scene's: for directions (grain, spotlight)
/// errors         Parse (too few numbers), Unsupported (a material that is not read, by name): file:line
Result<MappedMaterial> mapMaterial(const Primitive& primitive, double metresPerUnit, const Matrix4d& turn, WarningList& warnings);

/// Transmittance of a pane at normal incidence from Radiance's transmissivity (what is left after one way through the
/// glass), and back. `ior` > 1; all multiple reflections in the pane are counted.
double paneTransmittance(double transmissivity, double ior);
double paneTransmissivity(double transmittance, double ior);

}  // namespace luxdeck::rad
