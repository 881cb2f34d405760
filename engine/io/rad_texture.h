#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"
#include "engine/io/rad_primitive.h"

#include <optional>
#include <vector>

namespace luxdeck::rad {

/// The normals that a texture gives to points, where it is one that smooths the triangles of a mesh: tmesh.cal (mgf2rad,
/// obj2rad) or surf.cal (gensurf -s). Nothing for any other.
///
/// points  #P x 3, in the file's unit
/// normal  of the flat surface, unit
std::optional<std::vector<Vec3d>> smoothedNormals(const Primitive& texture, const std::vector<Vec3d>& points, const Vec3d& normal);

}  // namespace luxdeck::rad
