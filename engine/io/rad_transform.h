#pragma once

#include "engine/core/result.h"
#include "engine/io/rad_primitive.h"
#include "engine/io/xform.h"

namespace luxdeck::rad {

/// The primitive as `xform` would write it: surfaces are moved, renamed and perhaps given another modifier;
/// patterns take the transform into their arguments; what is per unit of length is scaled.
///
/// errors  Parse: a surface without the number of arguments that its type has, file:line
Result<Primitive> transformed(const Primitive& primitive, const XformCopy& copy);

/// Checks that a surface has the number of arguments that its type has.
///
/// errors  Parse naming type, seen and expected, file:line
Result<void> checkArguments(const Primitive& surface);

}  // namespace luxdeck::rad
