#pragma once

#include "engine/core/result.h"
#include "engine/core/rgb.h"
#include "engine/core/vec.h"
#include "engine/io/cal_code.h"
#include "engine/scene/pattern.h"

#include <string>

namespace luxdeck {

/// A primitive's own coordinates: rays as its function file sees them.
/// source   Radiance's func.c: directions keep their length; S, Tx ... Kz are those of the way from the user's
///          coordinates to the primitive's
class PatternFrame {
public:
    /// errors   InvalidArgument: singular or not finite
    static Result<PatternFrame> create(const Matrix4d& toWorld, const std::string& where);

    [[nodiscard]] cal::Inputs inputs(const PatternPoint& at, const Rgb& materialColour) const;
    [[nodiscard]] Vec3d toWorld(const Vec3d& local) const;
    /// S, Tx, Ty, Tz, Ix ... Kz.
    [[nodiscard]] std::map<std::string, double, std::less<>> constants() const;

private:
    Matrix4d toWorld_;
    Matrix4d toLocal_;
    double shrink_ = 1;  ///< a length of the user's in the primitive's units
};

}  // namespace luxdeck
