#pragma once

#include "engine/io/gltf_material.h"

#include <array>
#include <cstdint>
#include <vector>

namespace luxdeck::gltf {

/// One primitive in the coordinates of its mesh, its vertices cut down to those that triangles use.
struct Primitive {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;  ///< as in the file; empty: none
    std::vector<Vec2> uvs;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::uint32_t material = 0;

    void turnRound();  ///< makes its triangles and normals face the other way
};

/// The most vertices and triangles that readMesh() can make of a mesh, from its accessors' counts alone.
struct MeshSize {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
};
MeshSize meshSize(Document& document, const JsonView& mesh);

/// The triangles of a mesh. Points and lines are skipped, morph targets left at rest, both with a warning.
std::vector<Primitive> readMesh(Document& document, const JsonView& mesh, MaterialReader& materials);

}  // namespace luxdeck::gltf
