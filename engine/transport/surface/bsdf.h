#pragma once

#include "engine/core/vec.h"
#include "engine/scene/needs.h"
#include "engine/scene/scene.h"
#include "engine/transport/spectrum.h"
#include "engine/transport/surface/microfacet.h"
#include "engine/transport/surface/surface_point.h"

namespace luxdeck {

/// How one point of a surface scatters light, in the frame of its shading normal. Directions point away
/// from the surface; wo is towards the viewer (z > 0).
///
/// One model serves all rough materials: a GGX lobe, what it loses to multiple scattering given back as a
/// diffuse-like lobe (Kulla & Conty 2017), and below it Lambert, fed by what the coat lets through both
/// ways (Kelemen & Szirmay-Kalos 2001). It is reciprocal and never reflects more than it gets.
template <Spectrum S>
class Bsdf {
public:
    Bsdf(const Scene& scene, const SceneNeeds& needs, const SurfacePoint& point);

    /// Mirror or pane: one or two directions, no others.
    [[nodiscard]] bool specular() const { return kind_ != Kind::Rough; }

    struct Value {
        S cosineWeighted;   // f |cos wi|
        float pdf;          // of sample() for wi [1/sr]
    };
    /// Rough materials, both directions on the same side (z > 0); zero elsewhere.
    [[nodiscard]] Value evaluate(const Vec3& wo, const Vec3& wi) const;

    struct Sample {
        Vec3 wi;
        S weight;            // f |cos| / pdf, or the specular throughput over its chance
        float pdf = 0;       // [1/sr]; 0: specular
        bool passedThrough = false;  // a pane, straight on
        bool absorbed = false;
    };
    [[nodiscard]] Sample sample(const Vec3& wo, float uLobe, Vec2 u) const;

    /// All it reflects for light from above, roughly: for steering and the constant ambient term.
    [[nodiscard]] S albedo(float cosine) const;

private:
    enum class Kind { Rough, Mirror, Pane };

    void setRough(S diffuse, S f0, float roughness);
    [[nodiscard]] S lobeTotal(const LobeAlbedo& e) const { return f0_ * e.bare + S(e.grazing) + multiple_ * (1 - e.total()); }
    [[nodiscard]] Sample sampleMirror(const Vec3& wo) const;
    [[nodiscard]] Sample samplePane(const Vec3& wo, float uLobe) const;

    Kind kind_ = Kind::Rough;
    bool coated_ = false;        // has a GGX lobe
    S diffuse_{0.0F};
    S f0_{0.0F};                 // of the lobe; of a mirror: its reflectance
    S multiple_{0.0F};           // colour of the lobe's multiple scattering
    float alpha_ = 0;
    float meanEscaped_ = 1;      // 1 - mean albedo of the lobe for F = 1
    S meanThrough_{1.0F};        // 1 - mean of lobeTotal
    float lobeChance_ = 0;       // of sampling the lobe
    const Material* pane_ = nullptr;
};

/// Radiance that the surface itself emits towards where the ray came from [cd/m^2].
Rgb emittedRadiance(const Scene& scene, const SceneNeeds& needs, const SurfacePoint& point);

}  // namespace luxdeck
