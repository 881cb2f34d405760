#include "engine/transport/surface/dielectric.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

Boundary boundaryLight(const Vec3& wo, float ratio) {
    const float cosineO = std::clamp(wo.z, 0.0F, 1.0F);
    // cos^2 of the refracted direction times ratio^2, in the form that does not cancel where ratio is near 1.
    const float cosine2 = (ratio - 1) * (ratio + 1) + cosineO * cosineO;
    if (!(cosine2 > 0)) return {};
    const float bent = std::sqrt(cosine2);  // ratio * cosine of the refracted direction
    const float rs = (cosineO - bent) / (cosineO + bent);
    const float rp = (ratio * ratio * cosineO - bent) / (ratio * ratio * cosineO + bent);
    Boundary out;
    out.reflected = std::min(0.5F * (rs * rs + rp * rp), 1.0F);
    out.refracted = Vec3(-wo.x, -wo.y, -bent).normalized();  // = (-wo_xy, -bent) / ratio
    return out;
}

}  // namespace luxdeck
