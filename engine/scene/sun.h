#pragma once

#include "engine/core/rgb.h"
#include "engine/core/vec.h"

namespace luxdeck {

/// The sun's angular radius as seen from the Earth, on average [rad].
inline constexpr double kSunHalfAngle = 0.2665 * kDegree;

/// A sun: a disc of constant radiance, infinitely far away.
struct Sun {
    Vec3 direction{0, 0, 1};              ///< towards it, unit
    double halfAngleRad = kSunHalfAngle;
    Rgb radiance{0.0F};                   ///< [cd/m^2]

    /// The sun that gives this illuminance to a surface facing it [lx].
    static Sun ofNormalLux(const Vec3& direction, double lux, const Rgb& colour = Rgb(1.0F),
                           double halfAngleRad = kSunHalfAngle);

    [[nodiscard]] double solidAngle() const;  ///< [sr]
    /// Whether a unit direction meets the disc.
    [[nodiscard]] bool covers(const Vec3& towards) const;
    /// What a surface facing it receives, per channel [lx].
    [[nodiscard]] Rgb normalIrradiance() const;
};

}  // namespace luxdeck
