#include "engine/volume/directions.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

Vec3d concentricHemisphere(double u, double v) {
    const double a = 2 * u - 1, b = 2 * v - 1;
    if (a == 0 && b == 0) return {0, 0, 1};
    const bool wide = std::abs(a) > std::abs(b);
    const double radius = wide ? a : b;
    const double angle = wide ? kPiD / 4 * (b / a) : kPiD / 2 - kPiD / 4 * (a / b);
    const double r2 = radius * radius, sine = radius * std::sqrt(2 - r2);
    return {sine * std::cos(angle), sine * std::sin(angle), 1 - r2};
}

Vec3 DirectionBins::direction(int bin, Vec2 within) const {
    const int hemisphere = bin / (side_ * side_), cell = bin % (side_ * side_);
    const double u = (cell % side_ + double{within.x}) / side_, v = (cell / side_ + double{within.y}) / side_;
    auto d = concentricHemisphere(u, v);
    if (hemisphere == 1) d.z = -d.z;
    return Vec3(d.normalized());
}

DirectionBins::Blend DirectionBins::blend(const Vec3& direction) const {
    const Vec2 s = squareOf(direction);
    const int hemisphere = direction.z < 0 ? 1 : 0;
    const float x = s.x * static_cast<float>(side_) - 0.5F, y = s.y * static_cast<float>(side_) - 0.5F;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
    Blend out{};
    for (int i = 0; i < 4; ++i) {
        const int column = x0 + (i & 1), row = y0 + (i >> 1);
        const bool beyond = column < 0 || column >= side_ || row < 0 || row >= side_;
        const int side = beyond ? 1 - hemisphere : hemisphere;
        out.bin[i] = (side * side_ + std::clamp(row, 0, side_ - 1)) * side_ + std::clamp(column, 0, side_ - 1);
        out.weight[i] = ((i & 1) != 0 ? fx : 1 - fx) * ((i >> 1) != 0 ? fy : 1 - fy);
    }
    return out;
}

}  // namespace luxdeck
