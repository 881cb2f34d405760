#include "engine/io/gltf_instances.h"

#include "engine/io/gltf_accessor.h"
#include "engine/io/gltf_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace luxdeck::gltf {

namespace {

constexpr const char* kExtension = "EXT_mesh_gpu_instancing";

/// One attribute of all instances: the extension's own, with what stands for it where it is missing.
struct Attribute {
    const char* name;
    int components;
    std::array<double, 4> otherwise;
};
constexpr std::array<Attribute, 3> kAttributes{
    {{"TRANSLATION", 3, {0, 0, 0, 0}}, {"ROTATION", 4, {0, 0, 0, 1}}, {"SCALE", 3, {1, 1, 1, 0}}}};

/// The accessor of an attribute, -1 where there is none; its shape is checked.
std::int64_t accessorOf(Document& document, const JsonView& attributes, const Attribute& attribute) {
    const auto json = attributes[attribute.name];
    const auto index = json.index(document.accessors().size(), "accessors", false);
    if (index < 0) return -1;
    const Accessor& accessor = document.accessors()[static_cast<std::size_t>(index)];
    const bool numbers = accessor.componentType == 5126 || accessor.normalized;
    if (accessor.components != attribute.components || !numbers)
        json.fail(fmt::format("accessors[{}] is not VEC{} of floats or normalised integers", index, attribute.components));
    else if (accessor.zeros)  // copies in one place, and as many as a few bytes claim
        json.fail(fmt::format("accessors[{}] has no bufferView, expected the instances' numbers", index),
                  ErrorCode::Unsupported);
    return document.failure.failed() ? -1 : index;
}

/// The values of an attribute, `components` for each instance.
std::vector<float> values(Document& document, const JsonView& attributes, const Attribute& attribute,
                          std::size_t count) {
    const auto index = accessorOf(document, attributes, attribute);
    if (index < 0) return {};
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0U);
    auto numbers = readNumbers(document, static_cast<std::size_t>(index), all);
    const auto wrong = std::find_if(numbers.begin(), numbers.end(), [](float x) { return !std::isfinite(x); });
    if (wrong != numbers.end())
        attributes[attribute.name].fail(fmt::format("instance {} has {}, expected finite numbers",
                                                    (wrong - numbers.begin()) / attribute.components, *wrong));
    return numbers;
}

}  // namespace

std::uint64_t instanceCount(Document& document, const JsonView& node) {
    const auto extension = node.extension(kExtension);
    if (!extension.present()) return 1;
    const auto attributes = extension["attributes"];
    const auto* object = attributes.object();
    if (object == nullptr || object->empty()) {
        attributes.fail("is missing or empty, expected TRANSLATION, ROTATION or SCALE");
        return 0;
    }
    std::uint64_t count = 0;
    std::string first;
    for (const auto& [name, value] : *object) {  // custom ones too: all have one value for each instance
        const auto json = attributes[name.c_str()];
        const auto index = json.index(document.accessors().size(), "accessors");
        if (document.failure.failed()) return 0;
        const auto here = document.accessors()[static_cast<std::size_t>(index)].count;
        if (!first.empty() && here != count) {
            json.fail(fmt::format("has {} instances, expected {} as {} has", here, count, first));
            return 0;
        }
        first = name, count = here;
    }
    bool placed = false;
    for (const auto& attribute : kAttributes) placed |= accessorOf(document, attributes, attribute) >= 0;
    return document.failure.failed() ? 0 : placed ? count : 1;
}

std::vector<Matrix4d> instancePlaces(Document& document, const JsonView& node, const Matrix4d& world) {
    const auto count = static_cast<std::size_t>(instanceCount(document, node));
    const auto extension = node.extension(kExtension);
    if (!extension.present()) return {world};
    std::array<std::vector<float>, 3> given;
    for (std::size_t a = 0; a < kAttributes.size(); ++a)
        given[a] = values(document, extension["attributes"], kAttributes[a], count);
    std::vector<Matrix4d> places;
    for (std::size_t i = 0; i < count && !document.failure.failed(); ++i) {
        std::array<std::array<double, 4>, 3> v{};
        for (std::size_t a = 0; a < kAttributes.size(); ++a) {
            v[a] = kAttributes[a].otherwise;
            const auto components = static_cast<std::size_t>(kAttributes[a].components);
            for (std::size_t c = 0; c < components && !given[a].empty(); ++c) v[a][c] = given[a][i * components + c];
        }
        const auto local = nodeMatrix({v[0][0], v[0][1], v[0][2]}, v[1], {v[2][0], v[2][1], v[2][2]});
        if (local) places.push_back(*local * world);
        else extension["attributes"]["ROTATION"].fail(fmt::format("instance {} is a quaternion without length", i));
    }
    return places;
}

}  // namespace luxdeck::gltf
