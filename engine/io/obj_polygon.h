#pragma once

#include "engine/core/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace luxdeck::obj {

/// Concave polygons of more corners than this are refused: cutting them takes time with the square of it.
inline constexpr std::size_t kMaxConcaveCorners = 4096;

/// Cuts a polygon into corners.size() - 2 triangles of the same orientation, as indices into `corners`:
/// a fan when it is convex, else by ears (in the plane of its mean normal). Nearly flat polygons are taken as flat.
///
/// corners    #C x 3, C >= 3
/// triangles  overwritten
/// returns    false: concave and larger than kMaxConcaveCorners
/// cost       O(C) when convex, else O(C^2) and O(C^3) at worst
bool triangulate(std::span<const Vec3d> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace luxdeck::obj
