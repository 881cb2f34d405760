#include "engine/transport/surface/ward.h"

#include "engine/sampling/warp.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// Narrower lobes than this lose all digits in float.
constexpr float kMinWidth = 1e-3F;

float lowered(float reflected, float through) { return reflected + through > 1 ? (1 - through) / reflected : 1.0F; }

/// The factor by which what is reflected must shrink for the surface to return no more than it gets.
Rgb bounded(const Rgb& reflected, const Rgb& through) {
    return {lowered(reflected.r, through.r), lowered(reflected.g, through.g), lowered(reflected.b, through.b)};
}

}  // namespace

// With H = wo + wi, not of unit length, and h = H / |H|: D(h) = exp(-tan^2) / (pi u v h_z^4) is a density of
// halfway vectors over h_z, and f = D / (4 (wo.h)^2). Since |H| = 2 wo.h both are ratios of |H| and H_z, and
// f cos / pdf = 2 wi_z / H_z is never above 2.
WardLobe::Lobe WardLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
    const Vec3 h = wo + wi;
    if (h.z < 1e-6F) return {0, 0};  // both along the surface, where the form has no limit
    const float x = h.x / (u * h.z), y = h.y / (v * h.z);
    const float gauss = std::exp(-(x * x + y * y)) / (kPi * u * v);
    const float ratio = h.length() / (h.z * h.z);
    const float value = gauss * ratio * ratio;
    return {value, 0.5F * value * h.z};
}

Vec3 WardLobe::sample(const Vec3& wo, Vec2 random) const {
    const float radius = std::sqrt(-std::log(1 - random.x)), angle = 2 * kPi * random.y;
    const Vec3 h = Vec3(u * radius * std::cos(angle), v * radius * std::sin(angle), 1).normalized();
    return h * (2 * dot(wo, h)) - wo;
}

template <Spectrum S>
WardSurface<S>::WardSurface(const Material& m, const Rgb& reflectance, const Rgb& specular) : perfect_(m.wardPerfect()) {
    const Rgb factor = bounded(reflectance + specular, m.diffuseTransmittance + m.specularTransmittance);
    parts_ = {fromRgb<S>(reflectance * factor), fromRgb<S>(specular * factor), fromRgb<S>(m.diffuseTransmittance),
              fromRgb<S>(m.specularTransmittance)};
    float sum = 0;
    for (std::size_t i = 0; i < kParts; ++i) sum += chance_[i] = brightness(parts_[i]);
    for (auto& c : chance_) c = sum > 0 ? c / sum : 0;
    reflected_ = {std::max(m.wardU, kMinWidth), std::max(m.wardV, kMinWidth)};
    through_ = {std::max(0.5F * m.wardU, kMinWidth), std::max(0.5F * m.wardV, kMinWidth)};
}

template <Spectrum S>
ScatterValue<S> WardSurface<S>::evaluate(const Vec3& wo, const Vec3& wi) const {
    const float cosine = std::abs(wi.z);
    if (!(cosine > 0) || wo.z <= 0) return {};
    const bool above = wi.z > 0;
    const Part flat = above ? kDiffuse : kDiffuseThrough, glossy = above ? kLobe : kLobeThrough;
    S f = part(flat) * (1 / kPi);
    float pdf = chance_[flat] * cosine / kPi;
    if (!perfect_ && chance_[glossy] > 0) {
        const auto lobe = (above ? reflected_ : through_).evaluate(wo, {wi.x, wi.y, cosine});
        f += part(glossy) * lobe.value;
        pdf += chance_[glossy] * lobe.pdf;
    }
    return {f * cosine, pdf, part(flat) * (cosine / kPi)};
}

template <Spectrum S>
typename WardSurface<S>::Part WardSurface<S>::choose(float u) const {
    auto last = kDiffuse;
    for (const auto p : {kDiffuse, kLobe, kDiffuseThrough, kLobeThrough}) {
        if (!(chance_[p] > 0)) continue;
        last = p;
        if (u < chance_[p]) return p;
        u -= chance_[p];
    }
    return last;  // rounding
}

template <Spectrum S>
ScatterSample<S> WardSurface<S>::sample(const Vec3& wo, float uPart, Vec2 u) const {
    const Part chosen = choose(uPart);
    const bool through = chosen == kDiffuseThrough || chosen == kLobeThrough;
    const bool lobe = chosen == kLobe || chosen == kLobeThrough;
    if (lobe && perfect_) return samplePerfect(wo, chosen);
    ScatterSample<S> out;
    out.wi = lobe ? (through ? through_ : reflected_).sample(wo, u) : cosineHemisphere(u);
    out.absorbed = !(out.wi.z > 0);
    if (out.absorbed) return out;
    if (through) out.wi.z = -out.wi.z;
    out.weighBy(evaluate(wo, out.wi));
    return out;
}

template <Spectrum S>
ScatterSample<S> WardSurface<S>::samplePerfect(const Vec3& wo, Part chosen) const {
    ScatterSample<S> out;
    out.passedThrough = chosen == kLobeThrough;
    out.wi = out.passedThrough ? -wo : Vec3(-wo.x, -wo.y, wo.z);
    out.weight = part(chosen) * (1 / chance_[chosen]);
    return out;
}

template class WardSurface<Rgb>;
template class WardSurface<Grey>;

}  // namespace luxdeck
