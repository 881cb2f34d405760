#pragma once

#include "engine/core/vec.h"

namespace luxdeck {

/// The GGX distribution with Smith's height-correlated masking, isotropic, in the local frame (normal +z).
/// alpha is the width, > 0. Sources: Walter et al. 2007; Heitz 2014; Heitz 2018 (visible normals).
struct Ggx {
    float alpha;

    [[nodiscard]] float distribution(const Vec3& h) const;
    [[nodiscard]] float lambda(float cosine) const;
    /// D G2 / (4 cos_o cos_i): the lobe without Fresnel [1/sr].
    [[nodiscard]] float lobe(const Vec3& wo, const Vec3& wi) const;
    /// A microfacet normal, by the density of those visible from wo.
    [[nodiscard]] Vec3 sampleVisible(const Vec3& wo, Vec2 u) const;
    /// Density of wi when it is wo mirrored at a sampled normal [1/sr].
    [[nodiscard]] float pdf(const Vec3& wo, const Vec3& wi) const;
};

/// Schlick's Fresnel factor: F = F0 + (1 - F0) c.
inline float schlick(float cosine) {
    const float m = 1 - cosine;
    return m * m * m * m * m;
}

/// What a lobe reflects in all, as a function of cosine and alpha: E = F0 * bare + grazing for Schlick's
/// Fresnel. Tabulated once by quadrature; symmetric use keeps reciprocity exact.
struct LobeAlbedo {
    float bare;
    float grazing;
    [[nodiscard]] float total() const { return bare + grazing; }
};
LobeAlbedo lobeAlbedo(float cosine, float alpha);
/// Cosine-weighted mean over the hemisphere.
LobeAlbedo meanLobeAlbedo(float alpha);

}  // namespace luxdeck
