#pragma once

#include "engine/core/result.h"
#include "engine/io/rad_primitive.h"

#include <span>
#include <string>

namespace luxdeck::rad {

/// The programs that write solids, as functions. `words` are their arguments without the program's name; what they
/// make has `place`, the command's. Errors: InvalidArgument with file:line, seen and expected.

/// material name x y z [-i] [-b bevel | -r radius] [-n segments]: a box with a corner in the origin.
Result<Primitives> genbox(std::span<const std::string> words, const Place& place);

/// material name N x1 y1 .. xN yN [-l x y z] [-c] [-e] [-r radius]: a polygon of the plane z = 0, extruded.
Result<Primitives> genprism(std::span<const std::string> words, const Place& place);

}  // namespace luxdeck::rad
