#include "engine/transport/lit_scene.h"

#include "engine/transport/sky_visibility.h"

namespace luxdeck {

Result<LitScene> LitScene::create(const Scene& scene) { return create(scene, SceneNeeds::of(scene)); }

Result<LitScene> LitScene::create(const Scene& scene, const SceneNeeds& needs) {
    auto raycaster = makeEmbreeRaycaster(scene);
    if (!raycaster) return raycaster.error();
    LitScene lit;
    lit.scene_ = &scene;
    lit.needs_ = std::make_unique<SceneNeeds>(needs);
    lit.raycaster_ = *std::move(raycaster);
    lit.lights_ = std::make_unique<LightSampler>(scene, needs);
    lit.mirrors_ = std::make_unique<Mirrors>(scene, needs);
    lit.sky_ = makeSkySampler(scene, needs, *lit.raycaster_);
    return lit;
}

}  // namespace luxdeck
