#pragma once

#include "engine/core/rgb.h"
#include "engine/scene/texture.h"

#include <string>

namespace luxdeck {

enum class MaterialKind {
    Matte,              ///< Lambert: reflectance
    Plastic,            ///< Lambert under a rough dielectric coat: reflectance, specular, roughness
    Metal,              ///< rough conductor: specular (colour at normal incidence), roughness
    Mirror,             ///< perfect specular: specular
    ThinGlass,          ///< a pane without thickness: transmittance at normal incidence, ior
    MetallicRoughness   ///< glTF 2.0: reflectance is the base colour; metallic, roughness
};

/// How a surface reflects, lets through and emits. Plain data; engine/transport/bsdf gives it meaning.
/// Reflectances are fractions 0..1 in the scene's working space.
struct Material {
    std::string name;
    MaterialKind kind = MaterialKind::Matte;
    Rgb reflectance{0.5F};    ///< diffuse (or base) colour [-]
    Rgb specular{0.04F};      ///< reflectance at normal incidence of the coat, metal or mirror [-]
    float roughness = 0.2F;   ///< perceptual: GGX alpha = roughness^2 [-]
    float metallic = 0;       ///< MetallicRoughness alone [-]
    Rgb transmittance{0.0F};  ///< ThinGlass: of the whole pane at normal incidence [-]
    float ior = 1.52F;        ///< ThinGlass
    Rgb emission{0.0F};       ///< radiance, both sides unless oneSidedEmission [cd/m^2]
    bool oneSidedEmission = true;    ///< emits on the side the geometric normal points to
    TextureSlot reflectanceTexture;  ///< multiplies reflectance
    TextureSlot metallicRoughnessTexture;  ///< G multiplies roughness, B metallic
    TextureSlot emissionTexture;     ///< multiplies emission
    std::string source;              ///< where the numbers are from, for the report

    [[nodiscard]] bool emits() const { return !emission.isBlack(); }
};

}  // namespace luxdeck
