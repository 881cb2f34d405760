#pragma once

#include "engine/io/gltf_document.h"

#include <cstdint>
#include <span>
#include <vector>

namespace luxdeck::gltf {

/// All components of the asked elements as numbers, normalised where the accessor says so: #elements x components.
/// A sparse index outside the accessor is noted in the document's failure.
///
/// elements  ascending, each < the accessor's count: what is not asked for is not touched, as many meshes
///           may share one large accessor
std::vector<float> readNumbers(Document& document, std::size_t accessor, std::span<const std::uint32_t> elements);

/// Vertex indices, each checked to be < vertexCount.
///
/// owner   the primitive, for messages
std::vector<std::uint32_t> readIndices(Document& document, std::size_t accessor, std::uint64_t vertexCount,
                                       const JsonView& owner);

}  // namespace luxdeck::gltf
