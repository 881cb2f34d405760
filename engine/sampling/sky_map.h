#pragma once

#include "engine/core/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace luxdeck {

/// All directions cut into texels of the same solid angle: each hemisphere is a disc by Lambert's azimuthal map, the
/// disc a square by Shirley and Chiu's. A texel is about 6 degrees wide and nearly square everywhere.
struct SkyMap {
    static constexpr std::uint32_t kSide = 24;
    static constexpr std::uint32_t kTexels = 2 * kSide * kSide;     // the upper hemisphere first
    static constexpr float kTexelSr = 4 * kPi / kTexels;

    /// The direction at u, in 0 .. 1 both, of a texel.
    static Vec3 direction(std::uint32_t texel, Vec2 u);
    static Vec3 centre(std::uint32_t texel) { return direction(texel, {0.5F, 0.5F}); }
    /// The texel of a unit direction.
    static std::uint32_t texelOf(const Vec3& direction);
};

/// A distribution over the texels of a SkyMap, in whole 65535ths: the same chances whoever sums them.
class SkyTable {
public:
    SkyTable() = default;
    /// weights  #SkyMap::kTexels, >= 0
    explicit SkyTable(std::span<const float> weights);

    struct Draw {
        std::uint32_t texel;
        float probability;
    };
    /// u in [0, 1); only when the table is not black.
    [[nodiscard]] Draw draw(float u) const;
    [[nodiscard]] float probability(std::uint32_t texel) const {
        return static_cast<float>(below_[texel + 1] - below_[texel]) / kWhole;
    }
    [[nodiscard]] bool black() const { return below_[SkyMap::kTexels] == 0; }

private:
    static constexpr float kWhole = 65535;
    std::array<std::uint16_t, SkyMap::kTexels + 1> below_{};  // the sum of all before
};

}  // namespace luxdeck
