#pragma once

#include "engine/core/vec.h"
#include "engine/io/gltf_document.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck::gltf {

/// A node of the scene that is shown, with its place.
struct PlacedNode {
    std::size_t node = 0;
    Matrix4d world;        ///< from the node's coordinates to the project's
    bool visible = true;   ///< KHR_node_visibility: false when it or an ancestor is hidden
};

/// The nodes of the default scene (the first one, when none is named), parents before children.
/// Wrong hierarchies (a node that is its own ancestor, or has two parents) are noted in the failure.
///
/// placement  from the file's coordinates to the project's
std::vector<PlacedNode> placeNodes(Document& document, const Matrix4d& placement);

/// Scaled, turned by a quaternion x y z w of any length, then moved; row vectors. None for a quaternion without length.
std::optional<Matrix4d> nodeMatrix(const std::array<double, 3>& translation, const std::array<double, 4>& rotation,
                                   const std::array<double, 3>& scale);

/// "nodes[3]", or the node's own name.
std::string nodeName(const JsonView& node);

}  // namespace luxdeck::gltf
