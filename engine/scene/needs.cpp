#include "engine/scene/needs.h"

#include <algorithm>

namespace luxdeck {

namespace {

/// Kinds and features of the materials that meshes really use.
void addMaterialNeeds(SceneNeeds& needs, const Scene& scene) {
    for (const auto& mesh : scene.meshes) {
        const auto& m = scene.materials[mesh.material];
        needs.specularChains |= m.kind == MaterialKind::Mirror || m.kind == MaterialKind::ThinGlass;
        needs.transmission |= m.kind == MaterialKind::ThinGlass;
        needs.glossy |= m.kind != MaterialKind::Matte;
        needs.textures |= m.reflectanceTexture.used() || m.metallicRoughnessTexture.used() || m.emissionTexture.used();
        needs.smoothNormals |= !mesh.normals.empty();
        needs.meshLights |= m.emits();
        needs.colour |= !m.reflectance.isGrey() || !m.specular.isGrey() || !m.transmittance.isGrey() || !m.emission.isGrey();
    }
}

}  // namespace

SceneNeeds SceneNeeds::of(const Scene& scene) {
    SceneNeeds needs{false, false, false, false, false, false, false, false, false, false, false};
    addMaterialNeeds(needs, scene);
    needs.colour |= needs.textures;  // texels are taken to be coloured without looking at each
    needs.sky = scene.sky.present();
    needs.colour |= needs.sky && !scene.sky.colour.isGrey();
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
    unless(needs.specularChains, "specular chains", "no mirror and no glass in the scene");
    unless(needs.transmission, "transmission of shadow rays", "no pane lets light through");
    unless(needs.glossy, "glossy lobes", "every surface is matte");
    unless(needs.textures, "textures", "no material uses a picture");
    unless(needs.smoothNormals, "interpolated normals", "every mesh is flat shaded");
    unless(needs.sky, "sky", "the project has none");
    unless(needs.meshLights, "emitting surfaces", "no surface emits");
    unless(needs.luminaireSurfaces, "luminous openings as surfaces", "no luminaire has an opening with an extent");
    unless(needs.manyLights, "a hierarchy over the luminaires", "so few that each is weighed at every point");
    unless(needs.colour, "colour", "all materials and lamps are grey: luminance alone is enough");
    unless(needs.rebasing, "re-basing", "the scene lies near its origin");
    return out;
}

}  // namespace luxdeck
