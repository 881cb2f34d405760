#pragma once

#include "engine/core/vec.h"
#include "engine/io/gltf_document.h"

#include <cstdint>
#include <vector>

namespace luxdeck::gltf {

/// How often a node places its mesh: once, or as EXT_mesh_gpu_instancing says. Wrong accessors are noted in the
/// failure. Reads counts alone, so that too many are refused before memory is asked for.
std::uint64_t instanceCount(Document& document, const JsonView& node);

/// Where a node places its mesh, from the mesh's coordinates to the project's: once for each instance.
///
/// world  from the node's coordinates to the project's
std::vector<Matrix4d> instancePlaces(Document& document, const JsonView& node, const Matrix4d& world);

}  // namespace luxdeck::gltf
