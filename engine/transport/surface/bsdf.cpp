#include "engine/transport/surface/bsdf.h"

#include "engine/sampling/warp.h"
#include "engine/scene/appearance.h"
#include "engine/transport/surface/dielectric.h"
#include "engine/transport/surface/glass.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// Narrower lobes than this lose all digits of D in float.
constexpr float kMinAlpha = 1e-3F;

Rgb textured(const Scene& scene, const SceneNeeds& needs, const Rgb& value, const TextureSlot& slot, const Vec2& uv) {
    if (!needs.textures || !slot.used()) return value;
    return value * scene.textures[static_cast<std::size_t>(slot.texture)].sample(slot.apply(uv));
}

Rgb atLeast(const Rgb& c, float low) { return {std::max(c.r, low), std::max(c.g, low), std::max(c.b, low)}; }
Grey atLeast(const Grey& c, float low) { return Grey(std::max(c.y, low)); }

Rgb mix(const Rgb& a, const Rgb& b, float t) { return a * (1 - t) + b * t; }

Rgb atMost1(const Rgb& c) { return {std::min(c.r, 1.0F), std::min(c.g, 1.0F), std::min(c.b, 1.0F)}; }

}  // namespace

template <Spectrum S>
Bsdf<S>::Bsdf(const Scene& scene, const SceneNeeds& needs, const SurfacePoint& point, float surroundingIor) {
    const Material& m = *point.material;
    Rgb reflectance = textured(scene, needs, m.reflectance, m.reflectanceTexture, point.uv), specular = m.specular;
    if (needs.patterns && m.reflectancePattern >= 0) {
        const Rgb factor = scene.patterns[static_cast<std::size_t>(m.reflectancePattern)]->value(point.patternPoint(scene));
        valid_ = isFinite(factor);
        reflectance = atMost1(reflectance * factor), specular = atMost1(specular * factor);
    }
    switch (needs.glossy ? m.kind : MaterialKind::Matte) {
        case MaterialKind::Matte: diffuse_ = fromRgb<S>(reflectance); break;
        case MaterialKind::Plastic: setRough(fromRgb<S>(reflectance), fromRgb<S>(specular), m.roughness); break;
        case MaterialKind::Metal: setRough(S(0.0F), fromRgb<S>(specular), m.roughness); break;
        case MaterialKind::Mirror: kind_ = Kind::Mirror, f0_ = fromRgb<S>(specular); break;
        case MaterialKind::ThinGlass: kind_ = Kind::Pane, pane_ = &m; break;
        case MaterialKind::MetallicRoughness: {
            const Rgb mr = textured(scene, needs, {1, m.roughness, m.metallic}, m.metallicRoughnessTexture, point.uv);
            setRough(fromRgb<S>(reflectance * (1 - mr.b)), fromRgb<S>(mix(Rgb(0.04F), reflectance, mr.b)), mr.g);
            break;
        }
        case MaterialKind::Ward: kind_ = Kind::Ward, ward_ = WardSurface<S>(m, reflectance, specular); break;
        case MaterialKind::Dielectric:
            kind_ = Kind::Boundary;
            iorRatio_ = point.frontFace ? m.ior / surroundingIor : surroundingIor / m.ior;
            break;
        case MaterialKind::Mix: break;  // not met itself: one of its parts is; black here
    }
}

template <Spectrum S>
void Bsdf<S>::setRough(S diffuse, S f0, float roughness) {
    coated_ = true;
    diffuse_ = diffuse, f0_ = f0;
    alpha_ = std::max(roughness * roughness, kMinAlpha);
    const LobeAlbedo mean = meanLobeAlbedo(alpha_);
    meanEscaped_ = std::max(1 - mean.total(), 1e-6F);
    const S meanFresnel = f0_ * (20.0F / 21.0F) + S(1.0F / 21.0F);  // of Schlick's over the hemisphere
    multiple_ = quotient(meanFresnel * meanFresnel * mean.total(), S(1.0F) - meanFresnel * meanEscaped_);
    meanThrough_ = atLeast(S(1.0F) - lobeTotal(mean), 1e-6F);  // a coat that reflects all lets nothing through
    const float lobe = brightness(lobeTotal(mean)), below = brightness(diffuse_ * meanThrough_);
    lobeChance_ = below > 0 ? std::clamp(lobe / (lobe + below), 0.1F, 0.9F) : 1.0F;
    if (brightness(multiple_) * meanEscaped_ > 0.01F) lobeChance_ = std::min(lobeChance_, 0.9F);
}

template <Spectrum S>
typename Bsdf<S>::Value Bsdf<S>::evaluate(const Vec3& wo, const Vec3& wi) const {
    if (kind_ == Kind::Ward) return ward_.evaluate(wo, wi);
    if (kind_ != Kind::Rough || wi.z <= 0 || wo.z <= 0) return {S(0.0F), 0};
    const float cosinePdf = wi.z / kPi;
    if (!coated_) return {diffuse_ * cosinePdf, cosinePdf, diffuse_ * cosinePdf};

    const Ggx ggx{alpha_};
    const LobeAlbedo eo = lobeAlbedo(wo.z, alpha_), ei = lobeAlbedo(wi.z, alpha_);
    const float fresnel = schlick(std::clamp(dot(wo, (wo + wi).normalized()), 0.0F, 1.0F));
    S f = (f0_ * (1 - fresnel) + S(fresnel)) * ggx.lobe(wo, wi);
    f += multiple_ * ((1 - eo.total()) * (1 - ei.total()) / (kPi * meanEscaped_));
    S below(0.0F);
    if (!diffuse_.isBlack())
        below = quotient(diffuse_ * (S(1.0F) - lobeTotal(eo)) * (S(1.0F) - lobeTotal(ei)), meanThrough_) * (1 / kPi);
    return {(f + below) * wi.z, lobeChance_ * ggx.pdf(wo, wi) + (1 - lobeChance_) * cosinePdf, below * wi.z};
}

template <Spectrum S>
typename Bsdf<S>::Sample Bsdf<S>::sample(const Vec3& wo, float uLobe, Vec2 u) const {
    switch (kind_) {
        case Kind::Rough: break;
        case Kind::Ward: return ward_.sample(wo, uLobe, u);
        case Kind::Mirror: return sampleMirror(wo);
        case Kind::Pane: return samplePane(wo, uLobe);
        case Kind::Boundary: return sampleBoundary(wo, uLobe);
    }
    Sample out;
    if (!coated_) {
        out.wi = cosineHemisphere(u);
        out.weight = out.diffuse = diffuse_;
        out.pdf = out.wi.z / kPi;
        out.absorbed = !(out.pdf > 0);
        return out;
    }
    if (uLobe < lobeChance_) {
        const Vec3 h = Ggx{alpha_}.sampleVisible(wo, u);
        out.wi = h * (2 * dot(wo, h)) - wo;
    } else {
        out.wi = cosineHemisphere(u);
    }
    out.weighBy(evaluate(wo, out.wi));
    return out;
}

template <Spectrum S>
S Bsdf<S>::diffuseFactor(float cosine) const {
    return coated_ ? S(1.0F) - lobeTotal(lobeAlbedo(cosine, alpha_)) : S(1.0F);
}

template <Spectrum S>
typename Bsdf<S>::Sample Bsdf<S>::sampleMirror(const Vec3& wo) const {
    Sample out;
    out.wi = {-wo.x, -wo.y, wo.z};
    out.weight = f0_;
    return out;
}

template <Spectrum S>
typename Bsdf<S>::Sample Bsdf<S>::samplePane(const Vec3& wo, float uLobe) const {
    const PaneLight light = paneLight(pane_->transmittance, pane_->ior, wo.z);
    const S reflected = fromRgb<S>(light.reflected), transmitted = fromRgb<S>(light.transmitted);
    const float chance = 1 - chanceThrough(wo.z);
    Sample out;
    if (uLobe < chance) {
        out.wi = {-wo.x, -wo.y, wo.z};
        out.weight = reflected * (1 / chance);
    } else {
        out.wi = -wo;
        out.weight = transmitted * (1 / (1 - chance));
        out.passedThrough = true;
    }
    return out;
}

template <Spectrum S>
float Bsdf<S>::chanceThrough(float cosine) const {
    const PaneLight light = paneLight(pane_->transmittance, pane_->ior, cosine);
    const float reflected = brightness(fromRgb<S>(light.reflected)), transmitted = brightness(fromRgb<S>(light.transmitted));
    return transmitted / (reflected + transmitted);
}

/// Each way by its chance, so that weights are 1, but for what crossing does to radiance: it is spread over, or
/// gathered from, a solid angle larger by the squared ratio. Over a way into a solid and out again it cancels.
template <Spectrum S>
typename Bsdf<S>::Sample Bsdf<S>::sampleBoundary(const Vec3& wo, float uLobe) const {
    const Boundary light = boundaryLight(wo, iorRatio_);
    if (uLobe < light.reflected) {
        auto out = sampleMirror(wo);
        out.weight = S(1.0F);
        return out;
    }
    Sample out;
    out.wi = light.refracted;
    out.weight = S(1 / (iorRatio_ * iorRatio_));
    out.refracted = true;
    return out;
}

template <Spectrum S>
S Bsdf<S>::albedo(float cosine) const {
    if (kind_ == Kind::Ward) return ward_.albedo();
    if (kind_ == Kind::Boundary) return S(1.0F);
    if (kind_ == Kind::Mirror) return f0_;
    if (kind_ == Kind::Pane) return fromRgb<S>(paneLight(pane_->transmittance, pane_->ior, cosine).reflected);
    if (!coated_) return diffuse_;
    const S lobe = lobeTotal(lobeAlbedo(cosine, alpha_));
    return lobe + diffuse_ * (S(1.0F) - lobe);
}

Rgb emittedRadiance(const Scene& scene, const SurfacePoint& point) {
    const Material& m = *point.material;
    if (!m.emits() || (m.oneSidedEmission && !point.frontFace)) return Rgb{};
    if (!m.emissionTexture.used() && m.emissionPattern < 0) return m.emission;
    return emittedRadiance(scene, m, point.patternPoint(scene));
}

template class Bsdf<Rgb>;
template class Bsdf<Grey>;

}  // namespace luxdeck
