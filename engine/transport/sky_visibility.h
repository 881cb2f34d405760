#pragma once

#include "engine/raycast/raycaster.h"
#include "engine/sampling/sky_sampler.h"
#include "engine/scene/needs.h"

#include <memory>

namespace luxdeck {

/// Lets the sampling of the sky ask a raycaster what hides it: everything but panes and holes. Both must outlive it.
std::unique_ptr<const SkyVisibility> makeSkyVisibility(const Scene& scene, const Raycaster& raycaster);

/// The sampler of a scene's sky and suns, with its view from inside the scene; null where there is no such light.
std::unique_ptr<SkySampler> makeSkySampler(const Scene& scene, const SceneNeeds& needs, const Raycaster& raycaster);

}  // namespace luxdeck
