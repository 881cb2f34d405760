#pragma once

#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace luxdeck {

/// What a scene needs of the stages that follow, computed once when it is loaded. A stage that is not
/// needed is left out, and said to be.
struct SceneNeeds {
    bool specularChains = true;   ///< mirrors or glass: light arrives over paths that next-event estimation cannot make
    bool transmission = true;     ///< shadow rays may pass through panes
    bool glossy = true;           ///< lobes beside Lambert's
    bool textures = true;
    bool smoothNormals = true;    ///< interpolated shading normals
    bool sky = true;
    bool meshLights = true;       ///< emitting surfaces
    bool luminaireSurfaces = true;///< openings with an extent, which rays can hit
    bool manyLights = true;       ///< too many to weigh one by one at every point
    bool colour = true;           ///< false: everything is grey, luminance alone is enough
    bool rebasing = true;         ///< the scene lies far from its origin

    bool scatteredTransmission = true;  ///< surfaces that scatter to their far side
    bool dielectrics = true;      ///< solids that refract, which a path must know that it is inside of
    bool alpha = true;            ///< holes by the alpha of a texture
    bool patterns = true;         ///< patterns and mixtures

    static SceneNeeds of(const Scene& scene);
    /// Every need on, whatever the scene: the same result, more slowly. For tests and benches.
    static SceneNeeds everything() { return {}; }
};

/// One line of "what was left out and why".
struct LeftOut {
    std::string what;
    std::string why;
};

std::vector<LeftOut> leftOut(const SceneNeeds& needs);

/// More luminaires than this and they are no longer weighed one by one at every point.
inline constexpr std::size_t kManyLights = 64;

}  // namespace luxdeck
