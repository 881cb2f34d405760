#include "engine/sampling/sky_map.h"

#include "engine/sampling/warp.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// The inverse of concentricDisc().
Vec2 concentricSquare(float x, float y) {
    const float radius = std::sqrt(x * x + y * y);
    if (radius == 0) return {0.5F, 0.5F};
    float angle = std::atan2(y, x);
    if (angle < -kPi / 4) angle += 2 * kPi;
    const float eighth = 4 / kPi;
    float a = 0, b = 0;
    if (angle < kPi / 4) a = radius, b = angle * eighth * radius;
    else if (angle < 3 * kPi / 4) b = radius, a = -(angle - kPi / 2) * eighth * radius;
    else if (angle < 5 * kPi / 4) a = -radius, b = -(angle - kPi) * eighth * radius;
    else b = -radius, a = (angle - 3 * kPi / 2) * eighth * radius;
    return {(a + 1) / 2, (b + 1) / 2};
}

}  // namespace

Vec3 SkyMap::direction(std::uint32_t texel, Vec2 u) {
    const std::uint32_t inside = texel % (kSide * kSide);
    const Vec2 square{(static_cast<float>(inside % kSide) + u.x) / kSide, (static_cast<float>(inside / kSide) + u.y) / kSide};
    const Vec2 disc = concentricDisc(square);
    const float r2 = std::min(disc.x * disc.x + disc.y * disc.y, 1.0F), stretch = std::sqrt(2 - r2);
    return {disc.x * stretch, disc.y * stretch, texel < kSide * kSide ? 1 - r2 : r2 - 1};
}

std::uint32_t SkyMap::texelOf(const Vec3& direction) {
    const float shrink = 1 / std::sqrt(1 + std::min(std::abs(direction.z), 1.0F));
    const Vec2 square = concentricSquare(direction.x * shrink, direction.y * shrink);
    const auto cell = [](float f) { return static_cast<std::uint32_t>(std::clamp(static_cast<int>(f * kSide), 0, static_cast<int>(kSide) - 1)); };
    return (direction.z >= 0 ? 0 : kSide * kSide) + cell(square.y) * kSide + cell(square.x);
}

SkyTable::SkyTable(std::span<const float> weights) {
    double sum = 0;
    for (const float w : weights) sum += w;
    if (!(sum > 0)) return;
    double before = 0;
    for (std::size_t i = 0; i < SkyMap::kTexels; ++i) {
        before += weights[i];
        below_[i + 1] = static_cast<std::uint16_t>(std::lround(std::min(before / sum, 1.0) * kWhole));
    }
}

SkyTable::Draw SkyTable::draw(float u) const {
    const auto wanted = static_cast<std::uint16_t>(std::min(u * kWhole, kWhole - 1));
    const auto above = std::upper_bound(below_.begin(), below_.end(), wanted);  // never the first, which is 0
    const auto texel = static_cast<std::uint32_t>(above - below_.begin() - 1);
    return {texel, probability(texel)};
}

}  // namespace luxdeck
