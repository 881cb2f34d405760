#include "engine/scene/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luxdeck {

namespace {

/// Linear values of the 256 codes. Source: IEC 61966-2-1.
std::array<float, 256> srgbTable() {
    std::array<float, 256> table{};
    for (int code = 0; code < 256; ++code) {
        const double v = code / 255.0;
        table[static_cast<std::size_t>(code)] =
            static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
    return table;
}

std::array<float, 256> linearTable() {
    std::array<float, 256> table{};
    for (int code = 0; code < 256; ++code) table[static_cast<std::size_t>(code)] = static_cast<float>(code) / 255.0F;
    return table;
}

/// The texel that stands at i, which may lie one or any number of pictures outside.
int wrapped(long long i, int size, TextureWrap wrap) {
    if (wrap == TextureWrap::Clamp) return static_cast<int>(std::clamp<long long>(i, 0, size - 1));
    const long long period = wrap == TextureWrap::Repeat ? size : 2LL * size;
    long long j = i % period;
    if (j < 0) j += period;
    return static_cast<int>(j < size ? j : 2LL * size - 1 - j);
}

/// Two neighbouring texels and the weight of the second.
struct Tap {
    int first, second;
    float weight;
};

Tap tap(float coordinate, int size, TextureWrap wrap) {
    // Texel i covers [i, i + 1); its colour is that of its middle. Beyond 2^31 texels there is no fraction
    // left in a float anyway, and the conversion to an integer must stay defined, NaN included.
    double x = static_cast<double>(coordinate) * size - 0.5;
    if (!(std::abs(x) < 2147483648.0)) x = 0;
    const double below = std::floor(x);
    const auto i = static_cast<long long>(below);
    return {wrapped(i, size, wrap), wrapped(i + 1, size, wrap), static_cast<float>(x - below)};
}

}  // namespace

Rgb Texture::sample(Vec2 uv) const {
    if (width <= 0 || height <= 0) return Rgb{1.0F};
    static const std::array<float, 256> kSrgb = srgbTable();
    static const std::array<float, 256> kLinear = linearTable();
    const auto& decode = srgb ? kSrgb : kLinear;
    const auto texel = [&](int x, int y) {
        const std::uint8_t* p = &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                           static_cast<std::size_t>(x))];
        return Rgb{decode[p[0]], decode[p[1]], decode[p[2]]};
    };
    const Tap u = tap(uv.x, width, wrapU);
    const Tap v = tap(uv.y, height, wrapV);
    const Rgb upper = texel(u.first, v.first) * (1 - u.weight) + texel(u.second, v.first) * u.weight;
    const Rgb lower = texel(u.first, v.second) * (1 - u.weight) + texel(u.second, v.second) * u.weight;
    return upper * (1 - v.weight) + lower * v.weight;
}

float Texture::alpha(Vec2 uv) const {
    if (width <= 0 || height <= 0) return 1.0F;
    const auto texel = [&](int x, int y) {
        return static_cast<float>(
            rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) + 3]);
    };
    const Tap u = tap(uv.x, width, wrapU);
    const Tap v = tap(uv.y, height, wrapV);
    const float upper = texel(u.first, v.first) * (1 - u.weight) + texel(u.second, v.first) * u.weight;
    const float lower = texel(u.first, v.second) * (1 - u.weight) + texel(u.second, v.second) * u.weight;
    return (upper * (1 - v.weight) + lower * v.weight) / 255.0F;
}

Vec2 TextureSlot::apply(Vec2 uv) const {
    // v runs down, so a turn that looks counter-clockwise has the opposite sign of the usual matrix. The
    // extension's own example (offset 0,1; quarter turn; scale 0.5 = the lower left quadrant) holds this way only.
    const float x = uv.x * scale.x;
    const float y = uv.y * scale.y;
    if (rotation == 0) return {x + offset.x, y + offset.y};
    const float c = std::cos(rotation);
    const float s = std::sin(rotation);
    return {c * x + s * y + offset.x, -s * x + c * y + offset.y};
}

}  // namespace luxdeck
