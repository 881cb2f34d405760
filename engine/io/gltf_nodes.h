#pragma once

#include "engine/core/vec.h"
#include "engine/io/gltf_document.h"

#include <cstddef>
#include <vector>

namespace luxdeck::gltf {

/// A node of the scene that is shown, with its place.
struct PlacedNode {
    std::size_t node = 0;
    Matrix4d world;  ///< from the node's coordinates to the project's
};

/// The nodes of the default scene (the first one, when none is named), parents before children.
/// Wrong hierarchies (a node that is its own ancestor, or has two parents) are noted in the failure.
///
/// placement  from the file's coordinates to the project's
std::vector<PlacedNode> placeNodes(Document& document, const Matrix4d& placement);

/// "nodes[3]", or the node's own name.
std::string nodeName(const JsonView& node);

}  // namespace luxdeck::gltf
