#pragma once

#include "engine/volume/directions.h"

#include <cstddef>
#include <span>
#include <vector>

namespace luxdeck {

/// How a sphere of moments is integrated from a sphere of radiance.
enum class Quadrature {
    Midpoint,  ///< a bin counts by the cosine at its centre (Greger 1996, eq. 4.3 and 4.8): the baseline
    Exact      ///< the radiance of a bin is constant, the cosine is integrated over it: a uniform field gives pi L
};

/// What each bin's radiance counts for the moment of order n in the direction of each bin [sr]:
///
///     H^n(w) = (n + 1) / 2 * sum_i L_i * integral over bin i of max(0, w_i . w)^n
///
/// Order 1 is irradiance. Rows of Exact sum to pi: the integral of (n + 1) / 2 cos^n over a hemisphere.
class MomentWeights {
public:
    /// order  >= 1 (irradiance) or more; 10^4 and beyond keep their meaning under Exact
    MomentWeights(const DirectionBins& bins, int order, Quadrature quadrature);

    /// What the radiance of bin `in` counts for the moments in the directions of all bins, #B.
    [[nodiscard]] std::span<const float> of(int in) const {
        return {weights_.data() + static_cast<std::size_t>(in) * static_cast<std::size_t>(count_), static_cast<std::size_t>(count_)};
    }
    [[nodiscard]] int count() const { return count_; }

private:
    int count_;
    std::vector<float> weights_;  // #B in x #B out: a bin at a time is spread over all moments, which the compiler does several at once
};

/// (n + 1) / 2 * max(0, c)^n: what light from one direction, of irradiance 1 on a surface that faces it, counts at cosine c.
float momentKernel(int order, float cosine);

}  // namespace luxdeck
