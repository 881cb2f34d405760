#include "engine/scene/needs.h"

#include <algorithm>

namespace luxdeck {

namespace {

bool isSpecularChain(const Material& m) {
    switch (m.kind) {
        case MaterialKind::Mirror:
        case MaterialKind::ThinGlass:
        case MaterialKind::Dielectric: return true;
        case MaterialKind::Ward: return m.wardPerfect() && !(m.specular.isBlack() && m.specularTransmittance.isBlack());
        case MaterialKind::Matte:
        case MaterialKind::Plastic:
        case MaterialKind::Metal:
        case MaterialKind::MetallicRoughness:
        case MaterialKind::Mix: return false;  // its parts are asked themselves
    }
    return false;
}

void addMaterial(SceneNeeds& needs, const Scene& scene, const Material& m) {
    needs.specularChains |= isSpecularChain(m);
    needs.transmission |= scene.letsStraightThrough(m);
    needs.glossy |= m.kind != MaterialKind::Matte;
    needs.textures |= m.reflectanceTexture.used() || m.metallicRoughnessTexture.used() || m.emissionTexture.used();
    needs.meshLights |= m.emits();
    needs.scatteredTransmission |= m.kind == MaterialKind::Ward && !(m.diffuseTransmittance.isBlack() &&
                                                                     (m.wardPerfect() || m.specularTransmittance.isBlack()));
    needs.dielectrics |= m.kind == MaterialKind::Dielectric;
    needs.alpha |= m.hasHoles();
    needs.patterns |= m.reflectancePattern >= 0 || m.emissionPattern >= 0 || m.kind == MaterialKind::Mix;
    for (const auto& c : {m.reflectance, m.specular, m.transmittance, m.emission, m.diffuseTransmittance, m.specularTransmittance})
        needs.colour |= !c.isGrey();
}

/// Kinds and features of the materials that meshes really use.
void addMaterialNeeds(SceneNeeds& needs, const Scene& scene) {
    for (const auto& mesh : scene.meshes) {
        const auto& m = scene.materials[mesh.material];
        addMaterial(needs, scene, m);
        if (m.kind == MaterialKind::Mix)
            for (const auto part : {m.mixFirst, m.mixSecond}) addMaterial(needs, scene, scene.materials[part]);
        needs.smoothNormals |= !mesh.normals.empty();
    }
}

}  // namespace

SceneNeeds SceneNeeds::of(const Scene& scene) {
    SceneNeeds needs{false, false, false, false, false, false, false, false, false, false, false, false, false, false, false};
    addMaterialNeeds(needs, scene);
    needs.colour |= needs.textures || needs.patterns;  // taken to be coloured without looking at each value
    needs.sky = scene.sky.present() || !scene.sky.suns.empty();
    needs.colour |= needs.sky && scene.sky.coloured();
    for (const auto& l : scene.luminaires) {
        const auto& type = scene.luminaireTypes[l.type];
        needs.luminaireSurfaces |= type.photometry.opening.shape != OpeningShape::Point;
        needs.colour |= !type.colour.isGrey();
    }
    needs.manyLights = scene.luminaires.size() > kManyLights;
    needs.rebasing = scene.origin != Vec3d(0, 0, 0);
    return needs;
}

std::vector<LeftOut> leftOut(const SceneNeeds& needs) {
    std::vector<LeftOut> out;
    const auto unless = [&](bool needed, const char* what, const char* why) {
        if (!needed) out.push_back({what, why});
    };
    unless(needs.specularChains, "specular chains", "no mirror, no glass and no refracting solid in the scene");
    unless(needs.transmission, "transmission of shadow rays", "no pane and no hole lets light through");
    unless(needs.glossy, "glossy lobes", "every surface is matte");
    unless(needs.textures, "textures", "no material uses a picture");
    unless(needs.smoothNormals, "interpolated normals", "every mesh is flat shaded");
    unless(needs.sky, "sky", "the project has none");
    unless(needs.meshLights, "emitting surfaces", "no surface emits");
    unless(needs.luminaireSurfaces, "luminous openings as surfaces", "no luminaire has an opening with an extent");
    unless(needs.manyLights, "a hierarchy over the luminaires", "so few that each is weighed at every point");
    unless(needs.colour, "colour", "all materials and lamps are grey: luminance alone is enough");
    unless(needs.scatteredTransmission, "light from the far side", "no surface scatters to its far side");
    unless(needs.dielectrics, "refraction", "no solid refracts");
    unless(needs.alpha, "holes by alpha", "no material has any");
    unless(needs.patterns, "patterns and mixtures", "no material uses one");
    unless(needs.rebasing, "re-basing", "the scene lies near its origin");
    return out;
}

}  // namespace luxdeck
