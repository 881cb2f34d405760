#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace luxdeck {

/// Which two neighbours along an axis a coordinate lies between (or beyond), and what each counts.
struct AxisPlace {
    std::size_t lower = 0;
    double lowerWeight = 0;
    double upperWeight = 0;  ///< of lower + 1
};

/// One dimension of tabulated data: evenly spaced or listed points, rising or falling, at least two.
/// source   Radiance's data.c: outside, the line through the last two goes on for one division, then falls off
///          with the distance
struct DataAxis {
    double begin = 0;
    double end = 1;
    std::size_t count = 2;
    std::vector<double> points;  ///< #count; empty: evenly spaced

    /// Weights are NaN for a coordinate that is not finite.
    [[nodiscard]] AxisPlace place(double at) const {
        if (!std::isfinite(at)) {
            constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
            return {0, kNaN, kNaN};
        }
        AxisPlace result;
        const double x = points.empty() ? evenPlace(at, result.lower) : listedPlace(at, result.lower);
        const auto i = double(result.lower);
        if (x > i + 2) {
            result.lowerWeight = 1 / (i - 1 - x);
            result.upperWeight = -2 * result.lowerWeight;
        } else if (x < i - 1) {
            result.upperWeight = 1 / (x - i);
            result.lowerWeight = -2 * result.upperWeight;
        } else {
            result.lowerWeight = i + 1 - x;
            result.upperWeight = x - i;
        }
        return result;
    }

private:
    /// The coordinate in divisions, and the division that it is in.
    double evenPlace(double at, std::size_t& lower) const {
        const auto last = double(count - 1);
        const double x = (at - begin) / (end - begin) * last;
        lower = static_cast<std::size_t>(std::clamp(std::floor(x), 0.0, last - 1));
        return x;
    }
    double listedPlace(double at, std::size_t& lower) const {
        const bool rising = points.back() > points.front();
        const auto above = std::upper_bound(points.begin(), points.end(), at,
                                            [rising](double a, double b) { return rising ? a < b : a > b; });
        const auto passed = static_cast<std::size_t>(above - points.begin());  // points not beyond `at`
        lower = std::clamp<std::size_t>(passed, 1, count - 1) - 1;
        return double(lower) + (at - points[lower]) / (points[lower + 1] - points[lower]);
    }
};

}  // namespace luxdeck
