#include "engine/io/cal_noise.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

namespace luxdeck::cal {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargest = 1e15;  // above, neighbouring doubles are too far apart to have a fraction

using Cell = std::array<std::int64_t, 3>;

/// -1..1 from a whole number: 31 bits of an integer polynomial. Only the low 32 bits of the seed count.
double hashed(std::uint32_t seed) {
    const std::uint32_t s = seed << 13U ^ seed;
    const std::uint32_t bits = (s * (s * s * 15731U + 789221U) + 1376312589U) & 0x7fffffffU;
    return 1.0 - bits / 1073741824.0;
}

/// A lattice point's random number; each quantity has multipliers of its own.
double hashed(const Cell& p, const std::array<std::uint32_t, 3>& multipliers) {
    std::uint32_t seed = 0;
    for (std::size_t i = 0; i < 3; ++i) seed += multipliers[i] * static_cast<std::uint32_t>(p[i]);
    return hashed(seed);
}

bool hasCell(double x, double y, double z) {
    return std::abs(x) < kLargest && std::abs(y) < kLargest && std::abs(z) < kLargest;
}

struct Sample {
    std::array<double, 4> f{};  // gradient x, y, z; value
};

/// The noise on the corner (axes = 0), edge (1), face (2) or in the cell (3): between two of the kind before.
Sample interpolated(const Cell& cell, const std::array<double, 3>& t, std::size_t corner, std::size_t axes) {
    static constexpr std::array<std::array<std::uint32_t, 3>, 4> kMultipliers{
        {{67, 59, 71}, {73, 79, 83}, {89, 97, 101}, {103, 107, 109}}};
    Sample result;
    if (axes == 0) {
        Cell p = cell;
        for (std::size_t i = 0; i < 3; ++i) p[i] += static_cast<std::int64_t>(corner >> i & 1U);
        for (std::size_t k = 0; k < 4; ++k) result.f[k] = hashed(p, kMultipliers[k]);
        return result;
    }
    const std::size_t axis = axes - 1;
    const Sample low = interpolated(cell, t, corner, axis);
    const Sample high = interpolated(cell, t, corner | std::size_t{1} << axis, axis);
    const double u = t[axis];
    const double highWeight = u * u * (3 - 2 * u);
    for (std::size_t k = 0; k < 4; ++k) result.f[k] = low.f[k] * (1 - highWeight) + high.f[k] * highWeight;
    const double lowSlope = u * (u - 1) * (u - 1), highSlope = u * u * (u - 1);
    result.f[3] += low.f[axis] * lowSlope + high.f[axis] * highSlope;
    return result;
}

}  // namespace

double noise3(double x, double y, double z, int component) {
    if (!hasCell(x, y, z)) return kNaN;
    const std::array<double, 3> lower{std::floor(x), std::floor(y), std::floor(z)};
    const Cell cell{static_cast<std::int64_t>(lower[0]), static_cast<std::int64_t>(lower[1]),
                    static_cast<std::int64_t>(lower[2])};
    return interpolated(cell, {x - lower[0], y - lower[1], z - lower[2]}, 0, 3).f[static_cast<std::size_t>(component)];
}

double fractalNoise3(double x, double y, double z) {
    if (!hasCell(x, y, z)) return kNaN;
    constexpr std::int64_t kSteps = 1000;  // in a cell's side
    constexpr std::array<std::uint32_t, 3> kMultipliers{17, 23, 29};
    const std::array<double, 3> at{x, y, z};
    Cell point{}, begin{};
    for (std::size_t i = 0; i < 3; ++i) {
        point[i] = static_cast<std::int64_t>(at[i] * double(kSteps));
        begin[i] = static_cast<std::int64_t>(std::floor(at[i])) * kSteps;
    }
    std::array<double, 8> corners{};
    for (std::size_t j = 0; j < 8; ++j) {
        Cell p = begin;
        for (std::size_t i = 0; i < 3; ++i) p[i] += (j >> i & 1U) != 0 ? kSteps : 0;
        corners[j] = hashed(p, kMultipliers);
    }
    for (std::int64_t half = kSteps / 2; half > 0; half /= 2) {
        std::size_t octant = 0;  // of the cube that the point is in
        for (std::size_t i = 0; i < 3; ++i) octant |= std::size_t{point[i] > begin[i] + half} << i;
        // The octant's corners: the cube's own one stays; the others are means over an edge, a face or the whole
        // cube, each displaced.
        std::array<double, 8> inner{};
        for (std::size_t k = 0; k < 8; ++k) {
            const std::size_t mid = k ^ octant;  // axes along which the corner lies halfway
            double sum = 0;
            int count = 0;
            for (std::size_t j = 0; j < 8; ++j) {
                if (((j ^ octant) & ~mid) != 0) continue;
                sum += corners[j];
                ++count;
            }
            inner[k] = sum / count;
            if (mid == 0) continue;
            Cell p = begin;
            for (std::size_t i = 0; i < 3; ++i)
                p[i] += (mid >> i & 1U) != 0 ? half : (octant >> i & 1U) != 0 ? 2 * half : 0;
            inner[k] += double(half) / double(kSteps) * hashed(p, kMultipliers);
        }
        corners = inner;
        for (std::size_t i = 0; i < 3; ++i) begin[i] += (octant >> i & 1U) != 0 ? half : 0;
    }
    double sum = 0;
    for (const double c : corners) sum += c;
    return sum / 8;
}

double randomOf(double x) {
    double y = x * (1 / (1 + x * x) + std::numbers::e);
    y += std::numbers::pi / 4 - std::floor(y);
    y = 1e5 / y;
    return y - std::floor(y);
}

}  // namespace luxdeck::cal
