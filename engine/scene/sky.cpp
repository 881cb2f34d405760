#include "engine/scene/sky.h"

#include <algorithm>

namespace luxdeck {

double Sky::horizontalLux() const {
    switch (kind) {
        case SkyKind::None: return 0.0;
        case SkyKind::Uniform: return kPiD * zenithCdM2;
        case SkyKind::CieOvercast: return 7.0 * kPiD / 9.0 * zenithCdM2;  // integral of (1 + 2 sin g) / 3 times cos
    }
    return 0.0;
}

Rgb Sky::radiance(const Vec3& direction) const {
    if (kind == SkyKind::None) return Rgb{};
    if (direction.z < 0.0F) return Rgb(static_cast<float>(groundReflectance * horizontalLux() / kPiD)) * colour;
    const double gradation = kind == SkyKind::CieOvercast ? (1.0 + 2.0 * std::min(direction.z, 1.0F)) / 3.0 : 1.0;
    return colour * static_cast<float>(zenithCdM2 * gradation);
}

}  // namespace luxdeck
