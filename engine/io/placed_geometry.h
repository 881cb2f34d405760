#pragma once

#include "engine/core/vec.h"
#include "engine/io/scene_files.h"
#include "engine/scene/scene.h"

#include <vector>

namespace luxdeck {

/// A mesh whose vertices are still in double, in the project's metres: `mesh.positions` is empty.
struct PlacedMesh {
    Mesh mesh;
    std::vector<Vec3d> positions;  ///< #V x 3 [m]
};

/// From a file's coordinates to the project's: axes, then metres, then GeometryPlacement::transform.
Matrix4d placementMatrix(const GeometryPlacement& placement, bool yUp);

/// Normals by the matrix's cofactors, which also serve when it is singular (a plane scaled flat). Returns
/// false when one of them has no length or is not finite: the mesh is then to be shaded flat.
bool transformNormals(const Matrix4d& matrix, std::vector<Vec3>& normals);

/// True when the matrix mirrors, so that a triangle's corners must change order to keep facing outwards.
bool mirrors(const Matrix4d& matrix);

/// Moves the meshes into the part's scene, relative to chooseOrigin() of all of them and of the luminaires.
///
/// luminairePositions  one for each of part.scene.luminaires [m]
void storeRebased(ScenePart& part, std::vector<PlacedMesh> meshes, const std::vector<Vec3d>& luminairePositions);

/// Whether every vertex is in the range of floats.
bool allFinite(const Scene& scene);

}  // namespace luxdeck
