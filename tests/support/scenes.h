#pragma once

#include "engine/raycast/raycaster.h"
#include "engine/sampling/light_sampler.h"
#include "engine/sampling/sky_sampler.h"
#include "engine/scene/needs.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_builder.h"
#include "engine/transport/radiance_estimator.h"

#include <memory>
#include <string>

namespace luxdeck::test {

using luxdeck::axialTable;
using luxdeck::SceneBuilder;

/// A closed cube of side 4 m, reflectance rho, an isotropic point luminaire in the middle.
Scene cubeRoom(float rho, double lumens);
/// A room of 6 x 4 x 2.8 m with coloured walls, three luminaires, a table, a rough metal box and a pane.
Scene furnishedRoom();
/// Everything that SceneNeeds knows, in one small room: mirror, glass, texture, sky through an opening,
/// emitting surface, smooth normals, colour.
Scene richRoom();

/// A scene with all that an estimator stands on.
struct Lit {
    explicit Lit(Scene s, bool bruteForce = false);
    Lit(Scene s, SceneNeeds forced);

    Scene scene;
    SceneNeeds needs;
    std::unique_ptr<Raycaster> raycaster;
    std::unique_ptr<LightSampler> lights;
    std::unique_ptr<Mirrors> mirrors;
    std::unique_ptr<SkySampler> sky;

    [[nodiscard]] TransportScene transport() const { return {scene, needs, *raycaster, *lights, *mirrors, sky.get()}; }
    [[nodiscard]] std::unique_ptr<RadianceEstimator> estimator(const std::string& algorithm,
                                                               const AlgorithmSettings& settings = {}) const;
};

}  // namespace luxdeck::test
