#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"

#include <span>
#include <string>
#include <vector>

namespace luxdeck::rad {

/// A transform of Radiance: turns, moves, one scale for all axes, mirrors.
struct Xform {
    Matrix4d matrix;    ///< row vectors
    double scale = 1;   ///< of lengths, > 0
    bool mirrored = false;

    [[nodiscard]] Vec3d point(const Vec3d& p) const { return p * matrix; }
    [[nodiscard]] Vec3d vector(const Vec3d& v) const {
        Vec3d result(0, 0, 0);
        matrix.multDirMatrix(v, result);
        return result;
    }
};

/// Reads -t x y z, -rx -ry -rz degrees, -s factor, -mx -my -mz and -i times from the start of `words`, in their
/// order, and stops at the first word that is none of them.
///
/// used     how many words were read
/// errors   InvalidArgument: a number is missing or out of its range (without a place: the caller knows it)
Result<Xform> parseXform(std::span<const std::string> words, std::size_t& used);

/// What an xform command asks for, once its arrays (-a) are written out: one for each copy.
struct XformCopy {
    Xform xform;
    std::vector<std::string> words;  ///< the transform as patterns append it to their arguments
    std::string prefix;              ///< of surface names; empty: none
    std::string modifier;            ///< for all surfaces; empty: their own
    bool invert = false;             ///< surfaces face the other way
};
struct XformCommand {
    std::vector<XformCopy> copies;
    std::vector<std::string> files;  ///< to be read; empty: what a pipe brings
};

/// The arguments of a command `xform ...`, without -f, which the caller has replaced by what its file says.
///
/// mostCopies  more are an error
/// errors      InvalidArgument, Unsupported (an option that is not known)
Result<XformCommand> parseXformCommand(std::span<const std::string> words, std::size_t mostCopies);

}  // namespace luxdeck::rad
