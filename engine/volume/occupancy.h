#pragma once

#include "engine/scene/scene.h"
#include "engine/volume/lattice.h"

#include <array>
#include <cstdint>
#include <vector>

namespace luxdeck {

/// Whether a triangle touches a box. Source: Akenine-Moller 2001, "Fast 3D Triangle-Box Overlap Testing".
bool touches(const std::array<Vec3, 3>& triangle, const Box3& box);

/// Divides every cell that holds geometry of the scene, as often as the lattice's depth allows.
void divideByGeometry(Lattice& lattice, const Scene& scene);

/// Which cells hold geometry, #C.
std::vector<std::uint8_t> occupiedCells(const Lattice& lattice, const Scene& scene);

}  // namespace luxdeck
