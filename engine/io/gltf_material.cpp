#include "engine/io/gltf_material.h"

#include "engine/io/texture_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace luxdeck::gltf {

namespace {

/// All textures of a scene together; a small file may name one picture with many samplers.
constexpr std::uint64_t kMaxScenePixels = 4 * kMaxTexturePixels;

/// A surface that lets through more than this part of the light that enters it is a pane.
constexpr double kPaneTransmission = 0.5;

double reflectanceAtNormal(double ior) {
    const double r = (ior - 1) / (ior + 1);
    return r * r;
}

TextureWrap wrap(const JsonView& sampler, const char* key) {
    switch (sampler[key].count(10497)) {
        case 33071: return TextureWrap::Clamp;
        case 33648: return TextureWrap::Mirror;
        case 10497: return TextureWrap::Repeat;
        default: sampler[key].fail("is none of 33071, 33648, 10497"); return TextureWrap::Repeat;
    }
}

}  // namespace

void MaterialReader::warn(const Material& material, const std::string& text) {
    document_.warnings.add(fmt::format("material '{}': {}", material.name, text));
}

float MaterialReader::fraction(const JsonView& json, double value, const Material& material) {
    if (value < 0 || value > 1)
        warn(material, fmt::format("{} has {:g}, clamped to 0 .. 1", json.path(), value));
    return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

Rgb MaterialReader::colour(const JsonView& json, const Rgb& fallback, const Material& material) {
    if (!json.present()) return fallback;
    const auto c = json.numbers<3>({});
    return {fraction(json, c[0], material), fraction(json, c[1], material), fraction(json, c[2], material)};
}

void MaterialReader::readAll() {
    const auto list = document_.root()["materials"];
    for (std::size_t i = 0; i < list.size() && !document_.failure.failed(); ++i) uses_.push_back(read(list.at(i), i));
}

MaterialUse MaterialReader::use(std::int64_t index) {
    if (index >= 0) return uses_[static_cast<std::size_t>(index)];
    if (defaultMaterial_ < 0) {
        // glTF's own default is a perfectly white metal, which no designer means by leaving it out.
        defaultMaterial_ = static_cast<std::int64_t>(scene_.materials.size());
        scene_.materials.emplace_back().name = "default";
        scene_.materials.back().source = "a matte grey of 0.5, as the file gives no material";
        document_.warnings.add("surfaces without a material are taken as matte grey of reflectance 0.5");
    }
    return {static_cast<std::uint32_t>(defaultMaterial_), -1};
}

MaterialUse MaterialReader::read(const JsonView& json, std::size_t index) {
    MaterialUse use{static_cast<std::uint32_t>(scene_.materials.size()), -1};
    Material material;
    material.name = json["name"].text(fmt::format("material {}", index));
    material.source = fmt::format("glTF material {}", index);
    material.kind = MaterialKind::MetallicRoughness;
    readSpecular(json, material);
    if (const auto glossy = json.extension("KHR_materials_pbrSpecularGlossiness"); glossy.present())
        readSpecularGlossiness(glossy, use, material);
    else
        readMetallicRoughness(json["pbrMetallicRoughness"], use, material);
    readEmission(json, use, material);
    if (json.extension("KHR_materials_unlit").present()) {
        material.kind = MaterialKind::Matte;
        material.metallicRoughnessTexture = {};
        warn(material, "KHR_materials_unlit has no physical meaning; taken as matte");
    }
    readTransmission(json, material);
    readAlpha(json, material);
    checkUnusedTextures(json);
    warnOfTheRest(json, material);
    scene_.materials.push_back(std::move(material));
    return use;
}

void MaterialReader::readMetallicRoughness(const JsonView& json, MaterialUse& use, Material& material) {
    const auto factor = json["baseColorFactor"];
    const auto base = factor.numbers<4>({1, 1, 1, 1});
    material.reflectance = {fraction(factor, base[0], material), fraction(factor, base[1], material),
                            fraction(factor, base[2], material)};
    material.metallic = fraction(json["metallicFactor"], json["metallicFactor"].number(1), material);
    material.roughness = fraction(json["roughnessFactor"], json["roughnessFactor"].number(1), material);
    material.reflectanceTexture = readSlot(json["baseColorTexture"], true, use, material);
    material.metallicRoughnessTexture = readSlot(json["metallicRoughnessTexture"], false, use, material);
}

void MaterialReader::readEmission(const JsonView& json, MaterialUse& use, Material& material) {
    // KHR_materials_emissive_strength: factor times strength is in cd/m^2.
    const double strength = json.extension("KHR_materials_emissive_strength")["emissiveStrength"].number(1);
    if (strength < 0) json.extension("KHR_materials_emissive_strength")["emissiveStrength"].fail("is negative");
    const Rgb factor = colour(json["emissiveFactor"], Rgb{0.0F}, material);
    material.emission = factor * static_cast<float>(strength);
    material.oneSidedEmission = !json["doubleSided"].flag(false);
    const auto texture = readSlot(json["emissiveTexture"], true, use, material);
    if (material.emits()) material.emissionTexture = texture;
}

void MaterialReader::readSpecularGlossiness(const JsonView& json, MaterialUse& use, Material& material) {
    const auto diffuse = json["diffuseFactor"].numbers<4>({1, 1, 1, 1});
    material.specular = colour(json["specularFactor"], Rgb{1.0F}, material);
    // The extension's own diffuse part is what the specular one leaves: diffuse * (1 - max(specular)).
    const float left = 1 - material.specular.max();
    material.reflectance = Rgb{fraction(json, diffuse[0], material), fraction(json, diffuse[1], material),
                               fraction(json, diffuse[2], material)} * left;
    material.roughness = 1 - fraction(json, json["glossinessFactor"].number(1), material);
    material.reflectanceTexture = readSlot(json["diffuseTexture"], true, use, material);
    if (json["specularGlossinessTexture"].present())
        warn(material, "the specular-glossiness texture is left out, its factors are kept");
    const bool metal = material.reflectance.max() < 0.05F && material.specular.max() > 0.3F;
    material.kind = metal ? MaterialKind::Metal : MaterialKind::Plastic;
    warn(material, fmt::format("KHR_materials_pbrSpecularGlossiness read as {}", metal ? "metal" : "plastic"));
}

void MaterialReader::readSpecular(const JsonView& json, Material& material) {
    double ior = json.extension("KHR_materials_ior")["ior"].number(1.5);
    if (ior < 1 || ior > 4) {  // 0 is the extension's mark for materials that are no dielectrics
        warn(material, fmt::format("index of refraction {:g} is taken as 1.5, expected 1 .. 4", ior));
        ior = 1.5;
    }
    material.ior = static_cast<float>(ior);
    const auto extension = json.extension("KHR_materials_specular");
    const double factor = extension["specularFactor"].number(1);
    const auto tint = extension["specularColorFactor"].numbers<3>({1, 1, 1});
    const double f0 = reflectanceAtNormal(ior);
    const auto part = [&](double c) { return static_cast<float>(std::clamp(std::min(f0 * c, 1.0) * factor, 0.0, 1.0)); };
    material.specular = {part(tint[0]), part(tint[1]), part(tint[2])};
    for (const char* key : {"specularTexture", "specularColorTexture"})
        if (extension[key].present()) warn(material, fmt::format("{} is left out", key));
}

void MaterialReader::readTransmission(const JsonView& json, Material& material) {
    const auto extension = json.extension("KHR_materials_transmission");
    const auto factorJson = extension["transmissionFactor"];
    const float factor = fraction(factorJson, factorJson.number(0), material);
    if (factor == 0) return;
    if (factor <= kPaneTransmission) {
        warn(material, fmt::format("transmission {:g} is left out: the surface is taken as opaque", factor));
        return;
    }
    const bool approximated = extension["transmissionTexture"].present() || factor < 1 || material.roughness > 0.1F ||
                              material.metallic > 0 || json["pbrMetallicRoughness"]["baseColorTexture"].present();
    material.reflectanceTexture = {};
    material.metallicRoughnessTexture = {};
    const auto thickness = json.extension("KHR_materials_volume")["thicknessFactor"];
    if (thickness.number(0) < 0) return thickness.fail(fmt::format("is {:g}, expected >= 0", thickness.number(0)));
    const bool solid = thickness.number(0) > 0;
    Material pane = material;
    // Both faces reflect, again and again: a pane that absorbs nothing lets (1 - F) / (1 + F) through.
    const double f0 = reflectanceAtNormal(material.ior);
    pane.kind = MaterialKind::ThinGlass;
    pane.transmittance = material.reflectance * static_cast<float>(factor * (1 - f0) / (1 + f0));
    if (solid) {
        makeSolid(json, factor, material);
        const auto inside = material.transmittance;  // per metre, along the shortest way from face to face
        const auto metres = static_cast<float>(thickness.number(0) * metresPerUnit_);
        const auto way = [&](float t) { return static_cast<float>((1 - f0) / (1 + f0)) * std::pow(t, metres); };
        pane.transmittance = {way(inside.r), way(inside.g), way(inside.b)};
        panes_.emplace(static_cast<std::uint32_t>(scene_.materials.size()), pane);
    } else {
        material = std::move(pane);
    }
    if (approximated)
        warn(material, fmt::format("transmission is approximated by clear {} without texture or roughness",
                                   solid ? "glass" : "panes"));
}

/// The colour of the base tints light at each of the two faces that it goes through, the attenuation on the way between
/// them. Ours knows the way alone: the faces' part is spread over the thickness.
void MaterialReader::makeSolid(const JsonView& json, double factor, Material& material) {
    const auto volume = json.extension("KHR_materials_volume");
    const auto colourJson = volume["attenuationColor"], distanceJson = volume["attenuationDistance"];
    const Rgb colour = this->colour(colourJson, Rgb{1.0F}, material);
    const double distance = distanceJson.number(std::numeric_limits<double>::infinity()) * metresPerUnit_;
    if (!(distance > 0)) return distanceJson.fail(fmt::format("is {:g}, expected > 0", distance));
    const double thickness = volume["thicknessFactor"].number(0) * metresPerUnit_;
    const auto perMetre = [&](float attenuation, float base) {
        const double clear = std::isinf(distance) ? 1 : std::pow(static_cast<double>(attenuation), 1 / distance);
        return static_cast<float>(clear * std::pow(base * factor, 2 / thickness));
    };
    const Rgb base = material.reflectance;
    material.kind = MaterialKind::Dielectric;
    material.transmittance = {perMetre(colour.r, base.r), perMetre(colour.g, base.g), perMetre(colour.b, base.b)};
    if (volume["thicknessTexture"].present())
        warn(material, "thicknessTexture is left out: the mesh itself says how thick it is");
    if (base != Rgb{1.0F} || factor < 1)
        warn(material, "the tint of its faces is spread over its thickness");
}

std::optional<std::uint32_t> MaterialReader::coloured(std::int64_t material, obj::VertexColours& colours) {
    Material base;
    base.name = "vertex colours";
    base.reflectance = Rgb{1.0F};
    if (material >= 0) base = scene_.materials[static_cast<std::size_t>(material)];
    const bool fits = base.kind == MaterialKind::MetallicRoughness || base.kind == MaterialKind::Matte ||
                      base.kind == MaterialKind::Plastic;
    if (!fits || base.reflectanceTexture.used() || base.metallicRoughnessTexture.used() || base.emissionTexture.used())
        return std::nullopt;
    const auto index = colours.addMaterial(scene_, base.name);
    colours.finish(scene_, document_.warnings, false);
    auto& made = scene_.materials[index];
    base.reflectance *= made.reflectance;
    base.reflectanceTexture = made.reflectanceTexture;
    base.source = made.source;
    made = std::move(base);
    return index;
}

std::uint32_t MaterialReader::paneInstead(std::uint32_t material) {
    const auto [known, isNew] = usedPanes_.try_emplace(material, static_cast<std::uint32_t>(scene_.materials.size()));
    if (isNew) scene_.materials.push_back(panes_.at(material));
    return known->second;
}

void MaterialReader::readAlpha(const JsonView& json, Material& material) {
    const std::string mode = json["alphaMode"].text("OPAQUE");
    const auto cutoff = json["alphaCutoff"];
    if (cutoff.number(0.5) < 0) cutoff.fail("is negative");
    const bool clear = material.kind == MaterialKind::ThinGlass || material.kind == MaterialKind::Dielectric;
    if (mode == "OPAQUE" || clear) return;
    if (mode != "MASK" && mode != "BLEND") {
        json["alphaMode"].fail("is none of OPAQUE, MASK, BLEND");
        return;
    }
    const auto glossy = json.extension("KHR_materials_pbrSpecularGlossiness");
    const auto factor = glossy.present() ? glossy["diffuseFactor"] : json["pbrMetallicRoughness"]["baseColorFactor"];
    material.alpha = fraction(factor, factor.numbers<4>({1, 1, 1, 1})[3], material);
    const auto limit = static_cast<float>(cutoff.number(0.5));
    // Many exporters mark solid surfaces: where no texel has a hole there is nothing to ask for at every ray.
    const float least = leastAlpha(material);
    material.alphaBlend = mode == "BLEND" && least < 1;
    if (mode == "MASK" && least < limit) material.alphaCutoff = limit;
}

float MaterialReader::leastAlpha(const Material& material) const {
    if (!material.reflectanceTexture.used()) return material.alpha;
    const auto& texels = scene_.textures[static_cast<std::size_t>(material.reflectanceTexture.texture)].rgba;
    std::uint8_t least = 255;
    for (std::size_t i = 3; i < texels.size(); i += 4) least = std::min(least, texels[i]);
    return material.alpha * static_cast<float>(least) / 255.0F;
}

void MaterialReader::checkUnusedTextures(const JsonView& json) {
    // Not used for light, yet a wrong type in them says that the file is broken.
    const std::size_t textures = document_.root()["textures"].size();
    for (const auto& [key, factor] : {std::pair{"normalTexture", "scale"}, std::pair{"occlusionTexture", "strength"}}) {
        const auto info = json[key];
        if (!info.present()) continue;
        (void)info[factor].number(1);
        (void)info["index"].index(textures, "textures");
    }
    if (json["normalTexture"].present()) document_.warnings.add("normal map", "normal maps are left out");
}

void MaterialReader::warnOfTheRest(const JsonView& json, const Material& material) {
    static constexpr std::array<std::string_view, 6> kRead{
        "KHR_materials_emissive_strength", "KHR_materials_ior",   "KHR_materials_specular",
        "KHR_materials_transmission",      "KHR_materials_unlit", "KHR_materials_pbrSpecularGlossiness"};
    const auto* extensions = json["extensions"].object();
    if (extensions == nullptr) return;
    for (const auto& [name, value] : *extensions) {
        if (std::find(kRead.begin(), kRead.end(), name) != kRead.end()) continue;
        const bool clear = material.kind == MaterialKind::ThinGlass || material.kind == MaterialKind::Dielectric;
        if (name == "KHR_materials_volume" && clear) continue;
        warn(material, name + " is left out");
    }
}

TextureSlot MaterialReader::readSlot(const JsonView& info, bool srgb, MaterialUse& use, const Material& material) {
    TextureSlot slot;
    if (!info.present()) return slot;
    const auto texture = info["index"].index(document_.root()["textures"].size(), "textures");
    auto uvSet = info["texCoord"].count(0);
    if (const auto transform = info.extension("KHR_texture_transform"); transform.present()) {
        const auto offset = transform["offset"].numbers<2>({0, 0});
        const auto scale = transform["scale"].numbers<2>({1, 1});
        slot.offset = {static_cast<float>(offset[0]), static_cast<float>(offset[1])};
        slot.scale = {static_cast<float>(scale[0]), static_cast<float>(scale[1])};
        slot.rotation = static_cast<float>(transform["rotation"].number(0));
        uvSet = transform["texCoord"].count(uvSet);
    }
    if (document_.failure.failed()) return slot;
    const int set = static_cast<int>(std::min<std::uint64_t>(uvSet, 1000));
    if (use.uvSet >= 0 && use.uvSet != set) {
        warn(material, fmt::format("{} uses TEXCOORD_{} beside TEXCOORD_{}: the texture is left out", info.path(), set, use.uvSet));
        return {};
    }
    use.uvSet = set;
    slot.texture = sceneTexture(static_cast<std::size_t>(texture), info, srgb);
    return slot;
}

std::int32_t MaterialReader::sceneTexture(std::size_t index, const JsonView& info, bool srgb) {
    const auto root = document_.root();
    const auto json = root["textures"].at(index);
    if (!json["source"].present()) {
        json.fail("has no source that can be read (PNG or JPEG)", ErrorCode::Unsupported);
        return -1;
    }
    const auto image = json["source"].index(root["images"].size(), "images");
    const auto samplerIndex = json["sampler"].index(root["samplers"].size(), "samplers", false);
    if (document_.failure.failed()) return -1;
    TextureWrap wrapU = TextureWrap::Repeat, wrapV = TextureWrap::Repeat;
    if (samplerIndex >= 0) {
        const auto sampler = root["samplers"].at(static_cast<std::size_t>(samplerIndex));
        wrapU = wrap(sampler, "wrapS");
        wrapV = wrap(sampler, "wrapT");
    }
    const TextureKey key{static_cast<std::size_t>(image), wrapU, wrapV, srgb};
    if (const auto known = textures_.find(key); known != textures_.end()) return known->second;
    auto texture = decodeImage(root["images"].at(static_cast<std::size_t>(image)));
    if (!texture) {
        document_.failure.set(texture.error());
        return -1;
    }
    texturePixels_ += static_cast<std::uint64_t>(texture->width) * static_cast<std::uint64_t>(texture->height);
    if (texturePixels_ > kMaxScenePixels) {
        info.fail(fmt::format("textures have {} pixels in all, expected at most {}", texturePixels_, kMaxScenePixels),
                  ErrorCode::OutOfResources);
        return -1;
    }
    texture->srgb = srgb;
    texture->wrapU = wrapU;
    texture->wrapV = wrapV;
    scene_.textures.push_back(std::move(*texture));
    return textures_[key] = static_cast<std::int32_t>(scene_.textures.size() - 1);
}

Result<Texture> MaterialReader::decodeImage(const JsonView& image) {
    std::string loaded;
    std::string_view bytes;
    if (image["uri"].present()) {
        auto result = document_.load(image["uri"]);
        if (!result) return result.error();
        loaded = std::move(*result);
        bytes = loaded;
    } else {
        const auto view = image["bufferView"].index(document_.bufferViewCount(), "bufferViews");
        if (document_.failure.failed()) return document_.failure.error();
        bytes = document_.viewBytes(static_cast<std::size_t>(view));
    }
    const std::string uri = image["uri"].text();
    auto texture = decodeTexture(bytes, uri.empty() || uri.starts_with("data:") ? image["name"].text(image.path()) : uri);
    if (!texture)
        return Error{texture.error().code, fmt::format("{}: {}", image.path(), texture.error().text()), document_.failure.file()};
    return texture;
}

}  // namespace luxdeck::gltf
