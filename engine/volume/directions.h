#pragma once

#include "engine/core/vec.h"

#include <algorithm>
#include <cmath>
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
    [[nodiscard]] int binOf(const Vec3& direction) const {
        const Vec2 s = squareOf(direction);
        const auto cell = [&](float x) { return std::min(static_cast<int>(x * static_cast<float>(side_)), side_ - 1); };
        return ((direction.z < 0 ? side_ : 0) + cell(s.y)) * side_ + cell(s.x);
    }
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
    /// The concentric map's inverse, of the hemisphere that a direction lies in: both 0 .. 1.
    static Vec2 squareOf(const Vec3& d);

    int side_;
};

inline Vec2 DirectionBins::squareOf(const Vec3& d) {
    // Of the disc sqrt(2) sin(angle / 2) = sqrt(1 - |z|), in a form without cancellation near the pole.
    const float radius = std::sqrt((d.x * d.x + d.y * d.y) / (1 + std::abs(d.z)));
    const float ax = std::abs(d.x), ay = std::abs(d.y);
    const float large = std::max(ax, ay), t = std::min(ax, ay) / std::max(large, 1e-30F), t2 = t * t;
    // 4 / pi atan(t) on 0 .. 1 to 2e-6 rad, a thousandth of a bin's width where there are 64 across: millions are asked a second.
    const float turn = t * (0.99997726F + t2 * (-0.33262347F + t2 * (0.19354346F + t2 * (-0.11643287F + t2 * (0.05265332F - 0.01172120F * t2)))));
    // An eighth of the turn at a time: the square's coordinate across is linear in the angle.
    const float across = radius * std::min(turn * (4 / kPi), 1.0F);
    const bool wide = ax > ay;
    const float u = std::copysign(wide ? radius : across, d.x), v = std::copysign(wide ? across : radius, d.y);
    return {0.5F * u + 0.5F, 0.5F * v + 0.5F};
}

/// (u, v) of the unit square to the hemisphere about +z, area preserving.
Vec3d concentricHemisphere(double u, double v);

}  // namespace luxdeck
