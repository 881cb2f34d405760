#pragma once

#include "engine/sampling/sky_sampler.h"
#include "engine/transport/radiance_estimator.h"

#include <memory>

namespace luxdeck {

/// A scene made ready for light: what it needs, its raycaster, its lights. Owns them; the scene itself
/// must outlive it.
class LitScene {
public:
    /// needs    by default what the scene needs; tests force more
    /// errors   OutOfResources
    static Result<LitScene> create(const Scene& scene);
    static Result<LitScene> create(const Scene& scene, const SceneNeeds& needs);

    [[nodiscard]] const SceneNeeds& needs() const { return *needs_; }
    [[nodiscard]] const Raycaster& raycaster() const { return *raycaster_; }
    [[nodiscard]] const LightSampler& lights() const { return *lights_; }
    [[nodiscard]] TransportScene transport() const { return {*scene_, *needs_, *raycaster_, *lights_, *mirrors_, sky_.get()}; }

private:
    const Scene* scene_ = nullptr;
    std::unique_ptr<SceneNeeds> needs_;  // on the heap: estimators keep references while this moves
    std::unique_ptr<Raycaster> raycaster_;
    std::unique_ptr<LightSampler> lights_;
    std::unique_ptr<Mirrors> mirrors_;
    std::unique_ptr<SkySampler> sky_;  // null: nothing to sample
};

}  // namespace luxdeck
