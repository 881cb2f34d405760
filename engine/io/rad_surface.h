#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"
#include "engine/io/rad_primitive.h"

#include <array>
#include <cstdint>
#include <vector>

namespace luxdeck::rad {

/// How finely round surfaces are cut into triangles.
struct Fineness {
    double metresPerUnit = 1;
    bool fine = false;      ///< for what mirrors or refracts: ten times finer
    bool areaTrue = false;  ///< for what emits: the triangles have the area of the surface, and so its flux
};

/// A surface as triangles, in the file's unit. `normals` is empty where the surface is flat.
struct SurfaceMesh {
    std::vector<Vec3d> positions;
    std::vector<Vec3d> normals;  ///< unit, outwards: to the side that the triangles face
    std::vector<std::array<std::uint32_t, 3>> triangles;

    [[nodiscard]] double area() const;
};

/// Triangles of a polygon, sphere, bubble, cylinder, tube, cone, cup or ring.
///
/// The chords of a circle of radius r stay within min(r / 200, 0.5 mm) of it, fine ones within a tenth of that;
/// a circle has 16 to 512 of them (fine: 64 to 1024). Vertices lie on the surface unless `areaTrue`.
///
/// errors  Parse, Unsupported (a concave polygon of more corners than are cut): file:line
Result<SurfaceMesh> tessellate(const Primitive& surface, const Fineness& fineness);

/// How far the triangles' area is from the polygon's own, as a fraction: more than rounding where it crosses itself.
///
/// mesh  of a polygon: its positions are the corners in their order
double areaMismatch(const SurfaceMesh& mesh);

}  // namespace luxdeck::rad
