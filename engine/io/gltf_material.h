#pragma once

#include "engine/io/gltf_document.h"
#include "engine/io/obj_colours.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace luxdeck::gltf {

/// A glTF material in the scene, and which TEXCOORD_n of a mesh its textures ask for.
struct MaterialUse {
    std::uint32_t material = 0;  ///< index into Scene::materials
    int uvSet = -1;              ///< -1: no textures
};

/// Turns the document's materials into the scene's, and the pictures they use (and no others) into textures.
/// What has no counterpart in Material becomes the nearest that has, with a warning.
class MaterialReader {
public:
    MaterialReader(Document& document, Scene& scene) : document_(document), scene_(scene) {}

    /// What one unit of the file is, for what is absorbed on a length: 1 unless readAll() is told otherwise before [m].
    void setMetresPerUnit(double metres) { metresPerUnit_ = metres; }

    /// All materials of the document, in its order.
    void readAll();
    /// index  of the document; -1: a primitive without a material
    MaterialUse use(std::int64_t index);
    /// Whether a material of the scene is the surface of a solid (KHR_materials_volume with a thickness).
    [[nodiscard]] bool isSolid(std::uint32_t material) const { return panes_.contains(material); }
    /// A material of the scene, or matte for -1, whose reflectance is multiplied by colours of vertices; none where a
    /// picture already colours it or it has no such reflectance.
    std::optional<std::uint32_t> coloured(std::int64_t material, obj::VertexColours& colours);
    /// What stands for it on a surface that encloses nothing: a pane of its thickness.
    std::uint32_t paneInstead(std::uint32_t material);

private:
    using TextureKey = std::tuple<std::size_t, TextureWrap, TextureWrap, bool>;  // image, wraps, srgb

    MaterialUse read(const JsonView& json, std::size_t index);
    void readMetallicRoughness(const JsonView& json, MaterialUse& use, Material& material);
    void readEmission(const JsonView& json, MaterialUse& use, Material& material);
    void readSpecularGlossiness(const JsonView& extension, MaterialUse& use, Material& material);
    void readSpecular(const JsonView& json, Material& material);
    void readTransmission(const JsonView& json, Material& material);
    void makeSolid(const JsonView& json, double factor, Material& material);
    void readAlpha(const JsonView& json, Material& material);
    [[nodiscard]] float leastAlpha(const Material& material) const;
    void checkUnusedTextures(const JsonView& json);
    void warnOfTheRest(const JsonView& json, const Material& material);
    TextureSlot readSlot(const JsonView& info, bool srgb, MaterialUse& use, const Material& material);
    std::int32_t sceneTexture(std::size_t texture, const JsonView& info, bool srgb);
    Result<Texture> decodeImage(const JsonView& image);
    /// Reflectances and the like: outside 0 .. 1 they are clamped with a warning.
    float fraction(const JsonView& json, double value, const Material& material);
    Rgb colour(const JsonView& json, const Rgb& fallback, const Material& material);
    void warn(const Material& material, const std::string& text);

    Document& document_;
    Scene& scene_;
    std::vector<MaterialUse> uses_;
    std::int64_t defaultMaterial_ = -1;
    double metresPerUnit_ = 1;
    std::map<std::uint32_t, Material> panes_;          // by the solid's material
    std::map<std::uint32_t, std::uint32_t> usedPanes_; // the same, in the scene
    std::map<TextureKey, std::int32_t> textures_;
    std::uint64_t texturePixels_ = 0;
};

}  // namespace luxdeck::gltf
