#include "engine/transport/surface/glass.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// Internal transmittance t of one passage at normal incidence, from T = (1 - r)^2 t / (1 - r^2 t^2).
float internalTransmittance(float total, float r) {
    const float a = (1 - r) * (1 - r);
    // The quadratic's root in the form that does not cancel where little is reflected.
    return std::min(2 * total / (a + std::sqrt(a * a + 4 * r * r * total * total)), 1.0F);
}

struct Slab {
    float reflected, transmitted;
};
Slab slab(float r, float t) {
    const float common = (1 - r) * (1 - r) / (1 - r * r * t * t);
    return {r * (1 + common * t * t), common * t};
}

Slab unpolarised(float rs, float rp, float t) {
    const Slab s = slab(rs, t), p = slab(rp, t);
    return {0.5F * (s.reflected + p.reflected), 0.5F * (s.transmitted + p.transmitted)};
}

}  // namespace

PaneLight paneLight(const Rgb& transmittance, float ior, float cosine) {
    const float c1 = std::clamp(cosine, 1e-4F, 1.0F);
    const float c2 = std::sqrt(ior * ior - 1 + c1 * c1) / ior;  // not 1 - sin^2, which rounds to 0 at ior 1
    const auto square = [](float x) { return x * x; };
    const float rs = square((c1 - ior * c2) / (c1 + ior * c2)), rp = square((ior * c1 - c2) / (ior * c1 + c2));
    const float r0 = square((ior - 1) / (ior + 1));
    const auto channel = [&](float total) {
        return unpolarised(rs, rp, std::pow(internalTransmittance(total, r0), 1 / c2));
    };
    const Slab r = channel(transmittance.r), g = channel(transmittance.g), b = channel(transmittance.b);
    return {{r.reflected, g.reflected, b.reflected}, {r.transmitted, g.transmitted, b.transmitted}};
}

}  // namespace luxdeck
