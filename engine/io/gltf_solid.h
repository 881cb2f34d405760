#pragma once

#include "engine/io/gltf_mesh.h"

#include <vector>

namespace luxdeck::gltf {

/// What the surfaces of a would-be solid enclose.
enum class Shell {
    Open,     ///< an edge with a triangle on one side alone: nothing
    Outward,  ///< a solid whose triangles face away from it
    Inward    ///< one turned inside out
};

/// Of some primitives of one mesh together. Vertices in the same place are one, as exporters double them where normals
/// or texture coordinates break.
Shell shellOf(const std::vector<const Primitive*>& primitives);

}  // namespace luxdeck::gltf
