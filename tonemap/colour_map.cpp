#include "tonemap/colour_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace luxdeck::tonemap {

namespace {

struct Oklab {
    double lightness, a, b;
};

// Five points, evenly spaced.
constexpr std::array<Oklab, 5> kDusk{{{0.22, 0.015, -0.115},
                                      {0.40, -0.020, -0.105},
                                      {0.575, -0.085, -0.020},
                                      {0.75, -0.115, 0.095},
                                      {0.93, -0.045, 0.165}}};
constexpr std::array<Oklab, 5> kHeat{
    {{0.08, 0.010, 0.005}, {0.32, 0.105, 0.060}, {0.55, 0.135, 0.105}, {0.78, 0.030, 0.150}, {0.98, -0.010, 0.045}}};

constexpr std::array<Oklab, 5> kBalance{
    {{0.40, -0.020, -0.150}, {0.70, -0.025, -0.090}, {0.97, 0.000, 0.003}, {0.70, 0.115, 0.065}, {0.40, 0.145, 0.070}}};

double encoded(double linear) {
    const double v = std::clamp(linear, 0.0, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

/// Source: Ottosson 2020, "A perceptual color space for image processing".
Colour8 srgb(const Oklab& c) {
    const double l = std::pow(c.lightness + 0.3963377774 * c.a + 0.2158037573 * c.b, 3);
    const double m = std::pow(c.lightness - 0.1055613458 * c.a - 0.0638541728 * c.b, 3);
    const double s = std::pow(c.lightness - 0.0894841775 * c.a - 1.2914855480 * c.b, 3);
    const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(255 * encoded(v))); };
    return {byte(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            byte(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            byte(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

std::array<Colour8, 256> table(const std::array<Oklab, 5>& points) {
    std::array<Colour8, 256> out{};
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double t = static_cast<double>(i) / 255 * 4;
        const auto k = std::min<std::size_t>(static_cast<std::size_t>(t), 3);
        const double f = t - static_cast<double>(k);
        const auto mix = [&](double u, double v) { return u + f * (v - u); };
        const Oklab &p = points[k], &q = points[k + 1];
        out[i] = srgb({mix(p.lightness, q.lightness), mix(p.a, q.a), mix(p.b, q.b)});
    }
    return out;
}

}  // namespace

std::string_view name(ColourMap map) {
    switch (map) {
        case ColourMap::Dusk: return "dusk";
        case ColourMap::Heat: return "heat";
        case ColourMap::Balance: return "balance";
    }
    return "";
}

Result<ColourMap> colourMapNamed(std::string_view text) {
    if (text == "dusk") return ColourMap::Dusk;
    if (text == "heat") return ColourMap::Heat;
    if (text == "balance") return ColourMap::Balance;
    return Error{ErrorCode::InvalidArgument, fmt::format("colour map '{}', expected dusk, heat or balance", text), ""};
}

Colour8 colourAt(ColourMap map, double t) {
    static const auto dusk = table(kDusk), heat = table(kHeat), balance = table(kBalance);
    const auto i = static_cast<std::size_t>(std::lround(255 * std::clamp(t, 0.0, 1.0)));
    return map == ColourMap::Dusk ? dusk[i] : map == ColourMap::Heat ? heat[i] : balance[i];
}

}  // namespace luxdeck::tonemap
