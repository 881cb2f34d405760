#pragma once

#include "engine/core/vec.h"
#include "engine/scene/needs.h"
#include "engine/scene/scene.h"
#include "engine/transport/spectrum.h"
#include "engine/transport/surface/microfacet.h"
#include "engine/transport/surface/scattering.h"
#include "engine/transport/surface/surface_point.h"
#include "engine/transport/surface/ward.h"

namespace luxdeck {

/// How one point of a surface scatters light, in the frame of its shading normal. Directions point away
/// from the surface; wo is towards the viewer (z > 0).
///
/// Coated and metallic materials share one model: a GGX lobe, what it loses to multiple scattering given back as a
/// diffuse-like lobe (Kulla & Conty 2017), and below it Lambert, fed by what the coat lets through both
/// ways (Kelemen & Szirmay-Kalos 2001). It is reciprocal and never reflects more than it gets. Ward's is in
/// ward.h; perfectly specular ones give directions alone.
///
/// Mixtures and holes are settled before: the point's material is what the path meets.
template <Spectrum S>
class Bsdf {
public:
    using Value = ScatterValue<S>;
    using Sample = ScatterSample<S>;

    /// surroundingIor  of what lies around the solid whose surface this is
    Bsdf(const Scene& scene, const SceneNeeds& needs, const SurfacePoint& point, float surroundingIor = 1);

    /// Mirror, pane or boundary of a solid: one or two directions, no others.
    [[nodiscard]] bool specular() const { return kind_ >= Kind::Mirror || (kind_ == Kind::Ward && ward_.specular()); }
    /// Things seen in it keep their place, but for the mirror's turn: flat mirrors and panes.
    [[nodiscard]] bool keepsImages() const { return specular() && kind_ != Kind::Boundary; }
    /// Light from the far side is scattered too.
    [[nodiscard]] bool transmits() const { return kind_ == Kind::Ward && ward_.transmits(); }
    /// Light can go on behind the surface without having been scattered.
    [[nodiscard]] bool letsThrough() const {
        return kind_ == Kind::Pane || kind_ == Kind::Boundary || (kind_ == Kind::Ward && ward_.letsStraightThrough());
    }
    /// False where a pattern has no value.
    [[nodiscard]] bool valid() const { return valid_; }

    /// The parts that are not perfectly specular, wo above the surface (z > 0); wi on either side.
    [[nodiscard]] Value evaluate(const Vec3& wo, const Vec3& wi) const;
    [[nodiscard]] Sample sample(const Vec3& wo, float uLobe, Vec2 u) const;

    /// Of a pane: that sample() goes straight through it, at the cosine of wo.
    [[nodiscard]] float chanceThrough(float cosine) const;
    /// Has a coat, whose reflections dim what is below it by angle.
    [[nodiscard]] bool coated() const { return coated_; }
    /// What the diffuse part of Value and Sample depends on wo by, at the cosine of wo.
    [[nodiscard]] S diffuseFactor(float cosine) const;

    /// All it scatters of light from above, roughly: for steering and the constant ambient term.
    [[nodiscard]] S albedo(float cosine) const;

private:
    enum class Kind { Rough, Ward, Mirror, Pane, Boundary };

    void setRough(S diffuse, S f0, float roughness);
    [[nodiscard]] S lobeTotal(const LobeAlbedo& e) const { return f0_ * e.bare + S(e.grazing) + multiple_ * (1 - e.total()); }
    [[nodiscard]] Sample sampleMirror(const Vec3& wo) const;
    [[nodiscard]] Sample samplePane(const Vec3& wo, float uLobe) const;
    [[nodiscard]] Sample sampleBoundary(const Vec3& wo, float uLobe) const;

    Kind kind_ = Kind::Rough;
    bool coated_ = false;        // has a GGX lobe
    bool valid_ = true;
    S diffuse_{0.0F};
    S f0_{0.0F};                 // of the lobe; of a mirror: its reflectance
    S multiple_{0.0F};           // colour of the lobe's multiple scattering
    float alpha_ = 0;
    float meanEscaped_ = 1;      // 1 - mean albedo of the lobe for F = 1
    S meanThrough_{1.0F};        // 1 - mean of lobeTotal
    float lobeChance_ = 0;       // of sampling the lobe
    float iorRatio_ = 1;         // of a boundary: the far side's index of refraction over the viewer's side's
    const Material* pane_ = nullptr;
    WardSurface<S> ward_;
};

/// Radiance that the surface itself emits towards where the ray came from [cd/m^2].
Rgb emittedRadiance(const Scene& scene, const SurfacePoint& point);

}  // namespace luxdeck
