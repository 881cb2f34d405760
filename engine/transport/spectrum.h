#pragma once

#include "engine/core/rgb.h"

#include <concepts>

namespace luxdeck {

/// What light is carried as. Kernels are written once for both: Rgb, or Grey where the scene has no
/// colour and luminance alone is enough.
struct Grey {
    float y = 0;

    constexpr Grey() = default;
    constexpr explicit Grey(float value) : y(value) {}
    constexpr Grey& operator+=(const Grey& o) { return y += o.y, *this; }
    constexpr Grey& operator*=(const Grey& o) { return y *= o.y, *this; }
    constexpr Grey& operator*=(float s) { return y *= s, *this; }
    friend constexpr Grey operator+(Grey a, const Grey& b) { return a += b; }
    friend constexpr Grey operator-(const Grey& a, const Grey& b) { return Grey(a.y - b.y); }
    friend constexpr Grey operator*(Grey a, const Grey& b) { return a *= b; }
    friend constexpr Grey operator*(Grey a, float s) { return a *= s; }
    friend constexpr Grey operator*(float s, Grey a) { return a *= s; }
    [[nodiscard]] constexpr float max() const { return y; }
    [[nodiscard]] constexpr bool isBlack() const { return y == 0; }
};

template <class S>
concept Spectrum = std::same_as<S, Rgb> || std::same_as<S, Grey>;

template <Spectrum S>
constexpr S fromRgb(const Rgb& c) {
    if constexpr (std::same_as<S, Grey>) return Grey(c.g);  // all three are equal in a grey scene
    else return c;
}
constexpr Rgb toRgb(const Rgb& c) { return c; }
constexpr Rgb toRgb(const Grey& c) { return Rgb(c.y); }

/// One value to steer sampling by; never part of a result.
constexpr float brightness(const Rgb& c) { return luminance(c); }
constexpr float brightness(const Grey& c) { return c.y; }

constexpr Rgb quotient(const Rgb& a, const Rgb& b) { return {a.r / b.r, a.g / b.g, a.b / b.b}; }
constexpr Grey quotient(const Grey& a, const Grey& b) { return Grey(a.y / b.y); }


/// a / b where b is the larger of the two, 0 / 0 being 0.
constexpr float partOf(float a, float b) { return b > 0 ? a / b : 0.0F; }
constexpr Rgb partOf(const Rgb& a, const Rgb& b) { return {partOf(a.r, b.r), partOf(a.g, b.g), partOf(a.b, b.b)}; }
constexpr Grey partOf(const Grey& a, const Grey& b) { return Grey(partOf(a.y, b.y)); }

}  // namespace luxdeck
