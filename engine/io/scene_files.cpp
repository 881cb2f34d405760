#include "engine/io/scene_files.h"

#include "engine/core/file.h"
#include "engine/core/primaries.h"
#include "engine/io/rad_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace luxdeck {

Vec3d chooseOrigin(const Box3d& bounds) {
    if (bounds.isEmpty() || !isFinite(bounds.min) || !isFinite(bounds.max)) return {0, 0, 0};
    double farthestM = 0;
    for (int i = 0; i < 3; ++i) farthestM = std::max({farthestM, std::abs(bounds.min[i]), std::abs(bounds.max[i])});
    // A float keeps 24 bits: 8 micrometres at 100 m. Within twice its own size of the origin, a larger
    // scene would win less than two bits by moving.
    if (farthestM <= std::max(100.0, 2 * bounds.size().length())) return {0, 0, 0};
    const Vec3d centre = bounds.center();
    return {std::round(centre.x), std::round(centre.y), std::round(centre.z)};
}

bool isRadianceFile(const std::filesystem::path& path) {
    const auto extension = lowerExtension(path);
    return extension == ".rad" || extension == ".mat";
}

Result<ScenePart> readSceneFile(const std::filesystem::path& path, const GeometryPlacement& placement) {
    const auto extension = lowerExtension(path);
    if (extension == ".gltf" || extension == ".glb") return readGltf(path, placement);
    if (extension == ".obj") return readObj(path, placement);
    if (isRadianceFile(path)) return readRad({path}, placement);
    return Error{ErrorCode::Unsupported, fmt::format("geometry of type '{}', expected .gltf, .glb, .obj, .rad or .mat", extension),
                 path.string()};
}

namespace {

void moveSlot(TextureSlot& slot, std::int32_t firstTexture) {
    if (slot.used()) slot.texture += firstTexture;
}

void shift(Vec3& position, const Vec3d& by) { position = Vec3(Vec3d(position) + by); }

template <class T>
void moveInto(std::vector<T>& target, std::vector<T>& source) {
    target.insert(target.end(), std::make_move_iterator(source.begin()), std::make_move_iterator(source.end()));
}

/// Makes the part's indices count from where its things will stand in `scene`, and its coordinates from
/// the scene's origin.
void adapt(Scene& part, const Scene& scene) {
    const auto firstTexture = static_cast<std::int32_t>(scene.textures.size());
    for (auto& material : part.materials) {
        moveSlot(material.reflectanceTexture, firstTexture);
        moveSlot(material.metallicRoughnessTexture, firstTexture);
        moveSlot(material.emissionTexture, firstTexture);
        for (auto* pattern : {&material.reflectancePattern, &material.emissionPattern, &material.mixPattern})
            if (*pattern >= 0) *pattern += static_cast<std::int32_t>(scene.patterns.size());
        material.mixFirst += static_cast<std::uint32_t>(scene.materials.size());
        material.mixSecond += static_cast<std::uint32_t>(scene.materials.size());
    }
    const Vec3d by = part.origin - scene.origin;
    const bool moved = by != Vec3d(0, 0, 0);
    for (auto& mesh : part.meshes) {
        mesh.material += static_cast<std::uint32_t>(scene.materials.size());
        mesh.object += static_cast<std::uint32_t>(scene.objects.size());
        if (moved)
            for (auto& position : mesh.positions) shift(position, by);
    }
    for (auto& luminaire : part.luminaires) {
        luminaire.type += static_cast<std::uint32_t>(scene.luminaireTypes.size());
        if (moved) shift(luminaire.position, by);
    }
}

/// Makes the part's colours those of the scene's working space. Reflectances that leave 0..1 are cut off there.
void convertColours(Scene& part, const LuminanceWeights& to) {
    const auto matrix = rgbToRgb(chromaticitiesOf(part.weights), chromaticitiesOf(to));
    const auto convert = [&](Rgb& c, float most) {
        c = transformed(c, matrix);
        c = {std::clamp(c.r, 0.0F, most), std::clamp(c.g, 0.0F, most), std::clamp(c.b, 0.0F, most)};
    };
    constexpr float kUnlimited = std::numeric_limits<float>::max();
    for (auto& m : part.materials) {
        for (auto* c : {&m.reflectance, &m.specular, &m.transmittance, &m.diffuseTransmittance, &m.specularTransmittance}) convert(*c, 1);
        convert(m.emission, kUnlimited);
    }
    for (auto& type : part.luminaireTypes) convert(type.colour, kUnlimited);
    for (auto& dome : part.sky.domes) convert(dome.radiance, kUnlimited);
    for (auto& sun : part.sky.suns) convert(sun.radiance, kUnlimited);
    part.warnings.push_back(fmt::format("{}: its colours are of other primaries than the rest of the scene: converted, their luminance kept{}", part.name,
                                        part.patterns.empty() ? "" : "; its patterns are not"));
    part.weights = to;
}

}  // namespace

void append(Scene& scene, ScenePart part) {
    if (scene.meshes.empty() && scene.luminaires.empty()) scene.origin = part.scene.origin;
    if (scene.materials.empty()) scene.weights = part.scene.weights;
    if (part.scene.weights != scene.weights) convertColours(part.scene, scene.weights);
    adapt(part.scene, scene);
    moveInto(scene.objects, part.scene.objects);
    moveInto(scene.meshes, part.scene.meshes);
    moveInto(scene.materials, part.scene.materials);
    moveInto(scene.textures, part.scene.textures);
    moveInto(scene.patterns, part.scene.patterns);
    moveInto(scene.sky.domes, part.scene.sky.domes);
    moveInto(scene.sky.suns, part.scene.sky.suns);
    moveInto(scene.luminaireTypes, part.scene.luminaireTypes);
    moveInto(scene.luminaires, part.scene.luminaires);
    moveInto(scene.warnings, part.scene.warnings);
}

}  // namespace luxdeck
