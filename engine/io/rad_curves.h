#pragma once

#include "engine/core/result.h"
#include "engine/io/cal_library.h"
#include "engine/io/rad_primitive.h"

#include <filesystem>
#include <span>
#include <string>

namespace luxdeck::rad {

/// What generators of curved surfaces need beside their arguments.
struct CurveContext {
    Place place;                   ///< of the command
    std::filesystem::path folder;  ///< that function files (-f) are relative to
    CalLibrary& library;
};

/// The programs that write surfaces of functions. `words` are their arguments without the program's name.
/// Errors: InvalidArgument, Parse, FileNotFound with file:line.

/// material name x(s,t) y(s,t) z(s,t) m n [-s] [-e expression] [-f file]
Result<Primitives> gensurf(std::span<const std::string> words, const CurveContext& context);

/// material name z(t) r(t) n [-s] [-e expression] [-f file]: a surface of revolution about z
Result<Primitives> genrev(std::span<const std::string> words, const CurveContext& context);

/// material name x(t) y(t) z(t) r(t) n [-e expression] [-f file]: a string of varying thickness
Result<Primitives> genworm(std::span<const std::string> words, const CurveContext& context);

}  // namespace luxdeck::rad
