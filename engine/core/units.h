#pragma once

namespace luxdeck {

/// Strong types for API edges; kernels use plain numbers with the unit in the name (areaM2).
struct Lux {
    double value = 0;
};
struct Candela {
    double value = 0;
};
struct Metres {
    double value = 0;
};

inline constexpr double kMetresPerFoot = 0.3048;
inline constexpr double kMetresPerInch = 0.0254;
inline constexpr double kLuxPerFootcandle = 10.763910416709722;  // 1 / 0.3048^2

}  // namespace luxdeck
