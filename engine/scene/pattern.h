#pragma once

#include "engine/core/rgb.h"
#include "engine/core/vec.h"

#include <string>

namespace luxdeck {

/// Where a pattern is asked for its value.
struct PatternPoint {
    Vec3d position{0, 0, 0};   ///< in the user's coordinates [m]
    Vec3 normal{0, 0, 1};      ///< unit, towards where the ray came from
    Vec3 direction{0, 0, -1};  ///< of the ray, unit, towards the surface
    double distance = 0;       ///< along the ray since it started [m]
    Vec2 uv{0, 0};
};

/// A factor that varies over surfaces and directions: Radiance's brightfunc, colordata ... Constant after
/// it was made; safe to call from any number of threads.
class Pattern {
public:
    virtual ~Pattern() = default;
    /// The factor, finite; what is not finite or negative comes back as NaN, for the caller to count.
    [[nodiscard]] virtual Rgb value(const PatternPoint& at) const = 0;
    /// Text that is equal exactly when the patterns are: for the scene's hash.
    [[nodiscard]] virtual std::string identity() const = 0;
};

}  // namespace luxdeck
