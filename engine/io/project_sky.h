#pragma once

#include "engine/core/result.h"
#include "engine/io/project_sections.h"

namespace luxdeck::project {

/// The sky that a project describes, its weather file read.
///
/// errors  what the weather file's reader says; InvalidArgument: no such hour in it, no light in that hour, the sun
///         below the horizon
Result<Sky> makeSky(const SkySpec& spec, const LuminanceWeights& weights);

/// Gives it to a scene; what the scene's files say of sources stands in front of it.
Result<void> placeSky(Scene& scene, const SkySpec& spec);

}  // namespace luxdeck::project
