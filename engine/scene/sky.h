#pragma once

#include "engine/core/rgb.h"
#include "engine/core/vec.h"

namespace luxdeck {

enum class SkyKind { None, Uniform, CieOvercast };

/// What is seen where there is no surface. Luminances are those of the sky alone; below the horizon lies a
/// diffuse ground lit by it.
struct Sky {
    SkyKind kind = SkyKind::None;
    double zenithCdM2 = 0;         ///< luminance at the zenith [cd/m^2]
    double groundReflectance = 0.2;
    Rgb colour{1.0F};              ///< luminance 1

    [[nodiscard]] bool present() const { return kind != SkyKind::None && zenithCdM2 > 0; }
    /// Radiance from a unit direction [cd/m^2].
    [[nodiscard]] Rgb radiance(const Vec3& direction) const;
    /// Unobstructed horizontal illuminance [lx]: pi Lz (uniform), 7 pi Lz / 9 (CIE overcast).
    [[nodiscard]] double horizontalLux() const;
};

}  // namespace luxdeck
