#pragma once

#include <algorithm>
#include <cmath>

namespace luxdeck {

/// A colour in the scene's linear working space (default: Rec.709). As radiance its luminance() is in
/// cd/m^2, as irradiance in lx; as reflectance it has no unit.
struct Rgb {
    float r = 0;
    float g = 0;
    float b = 0;

    constexpr Rgb() = default;
    constexpr explicit Rgb(float grey) : r(grey), g(grey), b(grey) {}
    constexpr Rgb(float red, float green, float blue) : r(red), g(green), b(blue) {}

    constexpr Rgb& operator+=(const Rgb& o) { return r += o.r, g += o.g, b += o.b, *this; }
    constexpr Rgb& operator*=(const Rgb& o) { return r *= o.r, g *= o.g, b *= o.b, *this; }
    constexpr Rgb& operator*=(float s) { return r *= s, g *= s, b *= s, *this; }

    friend constexpr Rgb operator+(Rgb a, const Rgb& b) { return a += b; }
    friend constexpr Rgb operator-(const Rgb& a, const Rgb& b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
    friend constexpr Rgb operator*(Rgb a, const Rgb& b) { return a *= b; }
    friend constexpr Rgb operator*(Rgb a, float s) { return a *= s; }
    friend constexpr Rgb operator*(float s, Rgb a) { return a *= s; }
    friend constexpr Rgb operator/(Rgb a, float s) { return a *= 1.0F / s; }
    friend constexpr bool operator==(const Rgb&, const Rgb&) = default;

    [[nodiscard]] constexpr float max() const { return std::max({r, g, b}); }
    [[nodiscard]] constexpr float min() const { return std::min({r, g, b}); }
    [[nodiscard]] constexpr bool isBlack() const { return r == 0 && g == 0 && b == 0; }
    [[nodiscard]] constexpr bool isGrey() const { return r == g && g == b; }
};

/// The luminance of a unit of each primary of a working space [-]; they sum to 1.
struct LuminanceWeights {
    double r = 0.2126;  // Rec.709
    double g = 0.7152;
    double b = 0.0722;

    friend constexpr bool operator==(const LuminanceWeights&, const LuminanceWeights&) = default;
};

inline constexpr LuminanceWeights kRec709{};

constexpr float luminance(const Rgb& c, const LuminanceWeights& w = kRec709) {
    return static_cast<float>(w.r * c.r + w.g * c.g + w.b * c.b);
}
inline bool isFinite(const Rgb& c) {
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

}  // namespace luxdeck
