#pragma once

#include <cmath>
#include <vector>

namespace luxdeck::test {

/// How far Pearson's statistic of independent counts lies above its mean, in standard deviations: the cube
/// root of chi^2 / k is near normal (Wilson & Hilferty 1931). Neighbouring bins are pooled until at least 8 are
/// expected. A fixed bound of 4 raises a false alarm in 3e-5 of all cases; with fixed seeds a pass stays a pass.
inline double chiSquareZ(const std::vector<double>& counts, const std::vector<double>& expected) {
    double chi2 = 0, count = 0, mean = 0;
    int bins = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        count += counts[i], mean += expected[i];
        if (mean < 8 && i + 1 < counts.size()) continue;
        if (mean > 0) chi2 += (count - mean) * (count - mean) / mean, ++bins;
        else if (count > 0) return 1e9;  // something fell where nothing can
        count = mean = 0;
    }
    const double k = bins - 1;
    if (k < 1) return 0;
    return (std::cbrt(chi2 / k) - (1 - 2 / (9 * k))) / std::sqrt(2 / (9 * k));
}

}  // namespace luxdeck::test
