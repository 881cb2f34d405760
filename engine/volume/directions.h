#pragma once

#include "engine/core/vec.h"

#include <cstdint>

namespace luxdeck {

/// Bins of equal solid angle over the sphere: two hemispheres (+z, then -z), each a square of side x side cells under the
/// concentric equal-area map. Source: Shirley & Chiu 1997; Greger 1996, figure 4.3.
class DirectionBins {
public:
    explicit DirectionBins(int side) : side_(side) {}

    [[nodiscard]] int side() const { return side_; }
    /// 2 side^2
    [[nodiscard]] int count() const { return 2 * side_ * side_; }
    [[nodiscard]] double solidAngleSr() const { return 4 * kPiD / count(); }

    /// The bin of a unit direction: hemisphere, row v, column u.
    [[nodiscard]] int binOf(const Vec3& direction) const;
    /// The direction at (u, v) of a bin's square, both 0 .. 1, with the density of equal solid angles; unit.
    [[nodiscard]] Vec3 direction(int bin, Vec2 within) const;
    /// What stands for the bin.
    [[nodiscard]] Vec3 centre(int bin) const { return direction(bin, {0.5F, 0.5F}); }

    /// Bilinear weights of the four bins whose centres surround a direction; beyond an edge of its square lies the same
    /// place of the other hemisphere.
    struct Blend {
        int bin[4];
        float weight[4];
    };
    [[nodiscard]] Blend blend(const Vec3& direction) const;

private:
    int side_;
};

/// (u, v) of the unit square to the hemisphere about +z, area preserving.
Vec3d concentricHemisphere(double u, double v);

}  // namespace luxdeck
