#pragma once

#include "engine/scene/scene.h"

#include <cstddef>

namespace luxdeck {

/// Takes away emitting triangles that lie exactly on another one with the same side up: they would shine twice, since
/// each is asked for light. Of two the first stays. Surfaces that do not emit may lie on each other: a ray meets one.
///
/// returns  how many were taken away
std::size_t removeCoincidentEmitters(Scene& scene);

}  // namespace luxdeck
