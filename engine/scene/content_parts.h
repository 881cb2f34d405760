#pragma once

#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace luxdeck {

/// One thing of a scene that changes light: an object with its materials, a luminaire, the sky.
struct ContentPart {
    std::string name;  ///< "object desk 3"
    std::string hash;  ///< of its content
    Box3 bounds;       ///< re-based [m]; empty: everywhere
};

/// All of them, in the scene's order, so that what changed between two scenes can be named. Other parts, another
/// sceneHash(), but for the parts' order.
std::vector<ContentPart> contentParts(const Scene& scene);

}  // namespace luxdeck
