#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace luxdeck::rad {

struct GeneratedSky;

/// Where in which file, for messages.
struct Place {
    std::shared_ptr<const std::string> file;
    std::size_t line = 0;

    [[nodiscard]] std::string text() const { return (file ? *file : std::string()) + ":" + std::to_string(line); }
    [[nodiscard]] Error error(ErrorCode code, std::string message) const { return {code, std::move(message), text()}; }
};

/// One primitive of a scene description as the file gives it, or as a command made it.
struct Primitive {
    std::string modifier;
    std::string type;
    std::string name;
    std::vector<std::string> strings;  ///< of an alias: the name it stands for
    std::vector<double> numbers;       ///< the real arguments, in the file's unit
    std::vector<Vec3d> normals;        ///< of a polygon's corners, where a generator smooths it; else empty
    Place place;
    std::shared_ptr<const GeneratedSky> sky;  ///< of a pattern that gensky or gendaylit made
};

using Primitives = std::vector<Primitive>;

/// polygon, sphere ... : what has a place in space; everything else modifies.
bool isSurface(std::string_view type);
/// Whether Radiance has a primitive of that type.
bool isKnownType(std::string_view type);
/// Of the surfaces that have an inside and an outside: the other one (sphere: bubble); else the type itself.
std::string_view invertedType(std::string_view type);

}  // namespace luxdeck::rad
