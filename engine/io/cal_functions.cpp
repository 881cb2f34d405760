#include "engine/io/cal_functions.h"

#include "engine/io/cal_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <unordered_map>

namespace luxdeck::cal {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double bound(double low, double x, double high) { return low > x ? low : x > high ? high : x; }
double modulo(double n, double d) { return n - std::floor(n / d) * d; }
/// 0 for NaN would hide it.
double notNegative(double x) { return x < 0 ? 0 : x; }
/// Radiance's own grey: its primaries about the equal-energy white, to nine digits.
double grey(const double* a) { return notNegative(.265074126 * a[0] + .670114631 * a[1] + .064811243 * a[2]); }

double hermite(const double* a) {
    const double t = a[4], end = t * t * (3 - 2 * t);
    return a[0] * (1 - end) + a[1] * end + a[2] * t * (t - 1) * (t - 1) + a[3] * t * t * (t - 1);
}
double bezier(const double* a) {
    const double t = a[4], s = 1 - t;
    return a[0] * s * s * s + 3 * a[1] * s * s * t + 3 * a[2] * s * t * t + a[3] * t * t * t;
}
/// Uniform cubic B-spline between the second and the third control value.
double bspline(const double* a) {
    const double t = a[4], s = 1 - t;
    return (a[0] * s * s * s + a[1] * (3 * t * t * t - 6 * t * t + 4) + a[2] * (3 * s * s * s - 6 * s * s + 4) +
            a[3] * t * t * t) /
           6;
}
/// From near to far with the square of the distance, wholly far from 16 on.
double fade(const double* a) { return a[1] + (a[2] < 16 ? (a[0] - a[1]) / (1 + a[2] * a[2]) : 0); }

double smallest(const double* a, std::size_t n) {
    double result = a[0];
    for (std::size_t i = 1; i < n; ++i) result = std::isnan(a[i]) || a[i] < result ? a[i] : result;
    return result;
}
double largest(const double* a, std::size_t n) {
    double result = a[0];
    for (std::size_t i = 1; i < n; ++i) result = std::isnan(a[i]) || a[i] > result ? a[i] : result;
    return result;
}

using Arguments = const double*;

constexpr std::array kFunctions{
    NativeFunction{"if", 3, false, nullptr, Special::If},
    NativeFunction{"select", 1, false, nullptr, Special::Select},
    NativeFunction{"arg", 1, false, nullptr, Special::RealArgument},
    NativeFunction{"min", 1, true, smallest},
    NativeFunction{"max", 1, true, largest},
    NativeFunction{"sqrt", 1, false, [](Arguments a, std::size_t) { return std::sqrt(a[0]); }},
    NativeFunction{"exp", 1, false, [](Arguments a, std::size_t) { return std::exp(a[0]); }},
    NativeFunction{"log", 1, false, [](Arguments a, std::size_t) { return std::log(a[0]); }},
    NativeFunction{"log10", 1, false, [](Arguments a, std::size_t) { return std::log10(a[0]); }},
    NativeFunction{"sin", 1, false, [](Arguments a, std::size_t) { return std::sin(a[0]); }},
    NativeFunction{"cos", 1, false, [](Arguments a, std::size_t) { return std::cos(a[0]); }},
    NativeFunction{"tan", 1, false, [](Arguments a, std::size_t) { return std::tan(a[0]); }},
    NativeFunction{"asin", 1, false, [](Arguments a, std::size_t) { return std::asin(a[0]); }},
    NativeFunction{"acos", 1, false, [](Arguments a, std::size_t) { return std::acos(a[0]); }},
    NativeFunction{"atan", 1, false, [](Arguments a, std::size_t) { return std::atan(a[0]); }},
    NativeFunction{"atan2", 2, false, [](Arguments a, std::size_t) { return std::atan2(a[0], a[1]); }},
    NativeFunction{"floor", 1, false, [](Arguments a, std::size_t) { return std::floor(a[0]); }},
    NativeFunction{"ceil", 1, false, [](Arguments a, std::size_t) { return std::ceil(a[0]); }},
    NativeFunction{"erf", 1, false, [](Arguments a, std::size_t) { return std::erf(a[0]); }},
    NativeFunction{"erfc", 1, false, [](Arguments a, std::size_t) { return std::erfc(a[0]); }},
    NativeFunction{"rand", 1, false, [](Arguments a, std::size_t) { return randomOf(a[0]); }},
    NativeFunction{"hermite", 5, false, [](Arguments a, std::size_t) { return hermite(a); }},
    NativeFunction{"noise3", 3, false, [](Arguments a, std::size_t) { return noise3(a[0], a[1], a[2], 3); }},
    NativeFunction{"noise3x", 3, false, [](Arguments a, std::size_t) { return noise3(a[0], a[1], a[2], 0); }},
    NativeFunction{"noise3y", 3, false, [](Arguments a, std::size_t) { return noise3(a[0], a[1], a[2], 1); }},
    NativeFunction{"noise3z", 3, false, [](Arguments a, std::size_t) { return noise3(a[0], a[1], a[2], 2); }},
    NativeFunction{"noise3a", 3, false, [](Arguments a, std::size_t) { return noise3(a[0], a[1], a[2], 0); }},
    NativeFunction{"noise3b", 3, false, [](Arguments a, std::size_t) { return noise3(a[0], a[1], a[2], 1); }},
    NativeFunction{"noise3c", 3, false, [](Arguments a, std::size_t) { return noise3(a[0], a[1], a[2], 2); }},
    NativeFunction{"fnoise3", 3, false, [](Arguments a, std::size_t) { return fractalNoise3(a[0], a[1], a[2]); }},

    NativeFunction{"Acos", 1, false, [](Arguments a, std::size_t) { return std::acos(bound(-1, a[0], 1)); }},
    NativeFunction{"Asin", 1, false, [](Arguments a, std::size_t) { return std::asin(bound(-1, a[0], 1)); }},
    NativeFunction{"Atan2", 2, false,
                   [](Arguments a, std::size_t) { return a[0] == 0 && a[1] == 0 ? 0.0 : std::atan2(a[0], a[1]); }},
    NativeFunction{"Exp", 1, false, [](Arguments a, std::size_t) { return a[0] < -100 ? 0.0 : std::exp(a[0]); }},
    NativeFunction{"Sqrt", 1, false, [](Arguments a, std::size_t) { return std::sqrt(notNegative(a[0])); }},
    NativeFunction{"bound", 3, false, [](Arguments a, std::size_t) { return bound(a[0], a[1], a[2]); }},
    NativeFunction{"abs", 1, false, [](Arguments a, std::size_t) { return std::abs(a[0]); }},
    NativeFunction{"sgn", 1, false,
                   [](Arguments a, std::size_t) {
                       return a[0] > 0 ? 1.0 : a[0] < 0 ? -1.0 : a[0] == 0 ? 0.0 : kNaN;
                   }},
    NativeFunction{"sq", 1, false, [](Arguments a, std::size_t) { return a[0] * a[0]; }},
    NativeFunction{"frac", 1, false, [](Arguments a, std::size_t) { return a[0] - std::floor(a[0]); }},
    NativeFunction{"mod", 2, false, [](Arguments a, std::size_t) { return modulo(a[0], a[1]); }},
    NativeFunction{"tri", 2, false,
                   [](Arguments a, std::size_t) { return std::abs(a[1] - modulo(a[0] - a[1], 2 * a[1])); }},
    NativeFunction{"linterp", 3, false, [](Arguments a, std::size_t) { return (1 - a[0]) * a[1] + a[0] * a[2]; }},
    NativeFunction{"noop", 1, false, [](Arguments a, std::size_t) { return a[0]; }},
    NativeFunction{"clip", 1, false, [](Arguments a, std::size_t) { return bound(0, a[0], 1); }},
    NativeFunction{"noneg", 1, false, [](Arguments a, std::size_t) { return notNegative(a[0]); }},
    NativeFunction{"red", 3, false, [](Arguments a, std::size_t) { return notNegative(a[0]); }},
    NativeFunction{"green", 3, false, [](Arguments a, std::size_t) { return notNegative(a[1]); }},
    NativeFunction{"blue", 3, false, [](Arguments a, std::size_t) { return notNegative(a[2]); }},
    NativeFunction{"grey", 3, false, [](Arguments a, std::size_t) { return grey(a); }},
    NativeFunction{"clip_r", 3, false, [](Arguments a, std::size_t) { return bound(0, a[0], 1); }},
    NativeFunction{"clip_g", 3, false, [](Arguments a, std::size_t) { return bound(0, a[1], 1); }},
    NativeFunction{"clip_b", 3, false, [](Arguments a, std::size_t) { return bound(0, a[2], 1); }},
    NativeFunction{"clipgrey", 3, false, [](Arguments a, std::size_t) { return bound(0, grey(a), 1); }},
    NativeFunction{"fade", 3, false, [](Arguments a, std::size_t) { return fade(a); }},
    NativeFunction{"bezier", 5, false, [](Arguments a, std::size_t) { return bezier(a); }},
    NativeFunction{"bspline", 5, false, [](Arguments a, std::size_t) { return bspline(a); }},
};

}  // namespace

std::span<const NativeFunction> nativeFunctions() { return kFunctions; }

int nativeFunction(std::string_view name) {
    static const auto byName = [] {
        std::unordered_map<std::string_view, int> result;
        for (std::size_t i = 0; i < kFunctions.size(); ++i) result.emplace(kFunctions[i].name, static_cast<int>(i));
        return result;
    }();
    const auto at = byName.find(name);
    return at == byName.end() ? -1 : at->second;
}

}  // namespace luxdeck::cal
