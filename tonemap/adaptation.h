#pragma once

#include <algorithm>
#include <cmath>

namespace luxdeck::tonemap {

/// The darkest luminance that the eye sees [cd/m^2]. Source: Larson et al. 1997, section 4.
inline constexpr double kDarkestVisible = 1e-4;

/// The luminance step that an eye adapted to `luminance` just notices [cd/m^2]: rods in the dark, cones in the
/// light. Its pieces do not quite meet (1.2 % at log -1.44, 0.7 % at log 1.9); that is how it was published.
///
/// luminance  [cd/m^2], >= 0
/// source     Ferwerda et al. 1996, as used by Larson et al. 1997, table 1
inline double justNoticeableDifference(double luminance) {
    const double x = std::log10(std::max(luminance, 1e-30));
    double y = 0;
    if (x < -3.94) y = -2.86;
    else if (x < -1.44) y = std::pow(0.405 * x + 1.6, 2.18) - 2.86;
    else if (x < -0.0184) y = x - 0.395;
    else if (x < 1.9) y = std::pow(0.249 * x + 0.65, 2.7) - 0.72;
    else y = x - 1.255;
    return std::pow(10.0, y);
}

/// The finest grating that an eye adapted to `luminance` resolves [cycles/degree]. The fit falls below zero near
/// 3e-6 cd/m^2, so luminance counts as kDarkestVisible at least.
///
/// source  Shaler 1937, as fitted by Larson et al. 1997
inline double visualAcuity(double luminance) {
    return 17.25 * std::atan(1.4 * std::log10(std::max(luminance, kDarkestVisible)) + 0.35) + 25.72;
}

}  // namespace luxdeck::tonemap
