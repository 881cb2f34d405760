#include "engine/io/gltf_accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace luxdeck::gltf {

namespace {

template <class T>
T load(const char* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

/// Source: glTF 2.0, the table of normalised integers: f = max(c / (2^(b-1) - 1), -1), or c / (2^b - 1).
float component(const char* at, int type, bool normalized) {
    switch (type) {
        case 5120: return normalized ? std::max(float(load<std::int8_t>(at)) / 127.0F, -1.0F) : float(load<std::int8_t>(at));
        case 5121: return float(load<std::uint8_t>(at)) / (normalized ? 255.0F : 1.0F);
        case 5122:
            return normalized ? std::max(float(load<std::int16_t>(at)) / 32767.0F, -1.0F) : float(load<std::int16_t>(at));
        case 5123: return float(load<std::uint16_t>(at)) / (normalized ? 65535.0F : 1.0F);
        case 5125: return float(load<std::uint32_t>(at));
        default: return load<float>(at);
    }
}

std::uint32_t unsignedAt(const ElementRange& range, std::size_t i, int type) {
    const char* at = range.bytes.data() + i * range.strideBytes;
    switch (type) {
        case 5121: return load<std::uint8_t>(at);
        case 5123: return load<std::uint16_t>(at);
        default: return load<std::uint32_t>(at);
    }
}

void readElement(const Accessor& accessor, const ElementRange& range, std::size_t i, float* target) {
    const char* at = range.bytes.data() + i * range.strideBytes;
    const std::size_t bytes = componentBytes(accessor.componentType);
    for (int c = 0; c < accessor.components; ++c, at += bytes)
        target[c] = component(at, accessor.componentType, accessor.normalized);
}

}  // namespace

std::vector<float> readNumbers(Document& document, std::size_t index, std::span<const std::uint32_t> elements) {
    const Accessor& accessor = document.accessors()[index];
    const auto components = static_cast<std::size_t>(accessor.components);
    std::vector<float> numbers(elements.size() * components, 0.0F);
    if (!accessor.zeros)
        for (std::size_t i = 0; i < elements.size(); ++i)
            readElement(accessor, accessor.elements, elements[i], &numbers[i * components]);
    if (!accessor.sparse) return numbers;
    const SparseRange& sparse = *accessor.sparse;
    for (std::size_t i = 0; i < sparse.count; ++i) {
        const std::uint32_t target = unsignedAt(sparse.indices, i, sparse.indexType);
        if (target >= accessor.count) {
            document.failure.set(fmt::format("accessors[{}].sparse.indices", index),
                                 fmt::format("index {} is {}, expected less than {}", i, target, accessor.count));
            return numbers;
        }
        const auto asked = std::lower_bound(elements.begin(), elements.end(), target);
        if (asked != elements.end() && *asked == target)
            readElement(accessor, sparse.values, i, &numbers[static_cast<std::size_t>(asked - elements.begin()) * components]);
    }
    return numbers;
}

std::vector<std::uint32_t> readIndices(Document& document, std::size_t index, std::uint64_t vertexCount,
                                       const JsonView& owner) {
    const Accessor& accessor = document.accessors()[index];
    if (accessor.components != 1 ||
        (accessor.componentType != 5121 && accessor.componentType != 5123 && accessor.componentType != 5125)) {
        owner["indices"].fail(fmt::format("accessors[{}] is not SCALAR of type 5121, 5123 or 5125", index));
        return {};
    }
    if (accessor.sparse || accessor.zeros) {
        owner["indices"].fail(fmt::format("accessors[{}] is sparse or has no bufferView, which indices may not be", index),
                              ErrorCode::Unsupported);
        return {};
    }
    std::vector<std::uint32_t> indices(accessor.count);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        indices[i] = unsignedAt(accessor.elements, i, accessor.componentType);
        if (indices[i] >= vertexCount) {
            owner["indices"].fail(fmt::format("index {} is {}, but there are {} vertices", i, indices[i], vertexCount));
            return {};
        }
    }
    return indices;
}

}  // namespace luxdeck::gltf
