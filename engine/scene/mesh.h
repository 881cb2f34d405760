#pragma once

#include "engine/core/vec.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace luxdeck {

/// A triangle mesh of one material, in the scene's re-based coordinates [m].
struct Mesh {
    std::string name;                                   ///< of the object it is a part of, as in the file
    std::vector<Vec3> positions;                        ///< #V x 3 [m]
    std::vector<Vec3> normals;                          ///< #V x 3, unit; empty: flat shading
    std::vector<Vec2> uvs;                              ///< #V x 2; empty: no textures
    std::vector<std::array<std::uint32_t, 3>> triangles;///< #T x 3, each < #V
    std::uint32_t material = 0;                         ///< index into Scene::materials
    std::uint32_t object = 0;                           ///< index into Scene::objects
};

/// What a designer calls one thing: a desk, the walls. Meshes point at it.
struct SceneObject {
    std::string name;
    bool movable = false;  ///< furniture that may be moved in the plan
};

}  // namespace luxdeck
