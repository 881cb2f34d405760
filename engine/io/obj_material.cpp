#include "engine/io/obj_material.h"

#include "engine/core/file.h"
#include "engine/io/obj_mtl.h"
#include "engine/io/texture_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck::obj {

namespace {

/// illum models that speak of glass or refraction.
bool isTransparentModel(int illum) { return illum == 4 || illum == 6 || illum == 7 || illum == 9; }

bool isMirrorModel(int illum) { return illum == 3 || illum == 5; }

/// GGX roughness of a Blinn-Phong exponent: alpha^2 = 2 / (n + 2) (Walter et al. 2007), roughness^2 = alpha.
float roughnessOf(double exponent) {
    return static_cast<float>(std::pow(2.0 / (std::clamp(exponent, 0.0, 1e6) + 2.0), 0.25));
}

}  // namespace

void MaterialLibrary::warn(const Material& material, const std::string& text) {
    warnings_.add(fmt::format("material '{}': {}", material.name, text));
}

Result<void> MaterialLibrary::read(const std::filesystem::path& file) {
    folder_ = file.parent_path();
    const auto bytes = readFile(file);
    if (!bytes) {
        if (bytes.error().code != ErrorCode::FileNotFound) return bytes.error();
        warnings_.add(fmt::format("{} is not there: its materials are taken as matte grey of reflectance 0.5", file.string()));
        return {};
    }
    const auto records = parseMtl(*bytes, file.string(), warnings_);
    if (!records) return records.error();
    for (const auto& record : *records) {
        const auto index = static_cast<std::uint32_t>(scene_.materials.size());
        if (!indices_.try_emplace(record.name, index).second) {
            warnings_.add(fmt::format("{}: material '{}' is defined again: the first one counts", record.where, record.name));
            continue;
        }
        described_.insert(record.name);
        scene_.materials.push_back(convert(record));
    }
    return {};
}

std::uint32_t MaterialLibrary::find(const std::string& name) {
    const auto [known, isNew] = indices_.try_emplace(name, static_cast<std::uint32_t>(scene_.materials.size()));
    if (isNew) {
        auto& material = scene_.materials.emplace_back();
        material.name = name.empty() ? "default" : name;
        material.source = "a matte grey of 0.5, as no material library describes it";
        warn(material, "is not described: taken as matte grey of reflectance 0.5");
    }
    return known->second;
}

Rgb MaterialLibrary::reflectance(const Rgb& value, const char* key, const Material& material) {
    const Rgb clamped{std::clamp(value.r, 0.0F, 1.0F), std::clamp(value.g, 0.0F, 1.0F), std::clamp(value.b, 0.0F, 1.0F)};
    if (clamped != value)
        warn(material, fmt::format("{} is {:g} {:g} {:g}, clamped to 0 .. 1", key, value.r, value.g, value.b));
    return clamped;
}

TextureSlot MaterialLibrary::loadMap(const std::optional<MtlRecord::Map>& map, const Material& material) {
    if (!map) return {};
    const auto [known, isNew] = textures_.try_emplace({map->file, map->clamp}, -1);
    if (isNew) {
        const auto refuse = [&](const Error& error) {
            warn(material, fmt::format("texture {} is left out, its factor alone is used", error.text()));
            return TextureSlot{};
        };
        const auto found = files_.find(folder_, map->file);
        if (!found) return refuse(found.error());
        if (!found->note.empty()) warn(material, "a map " + found->note);
        const auto bytes = readFile(found->path);
        if (!bytes) return refuse(bytes.error());
        auto texture = decodeTexture(*bytes, map->file);
        if (!texture) return refuse(texture.error());
        if (map->clamp) texture->wrapU = texture->wrapV = TextureWrap::Clamp;
        known->second = static_cast<std::int32_t>(scene_.textures.size());
        scene_.textures.push_back(std::move(*texture));
    }
    TextureSlot slot = map->slot;
    slot.texture = known->second;
    return slot.used() ? slot : TextureSlot{};
}

Material MaterialLibrary::convert(const MtlRecord& record) {
    Material material;
    material.name = record.name;
    material.source = record.where;
    material.reflectance = reflectance(record.kd.value_or(Rgb{0.5F}), "Kd", material);
    if (!record.kd) warn(material, "has no Kd: taken as 0.5");
    material.specular = reflectance(record.ks.value_or(Rgb{0.0F}), "Ks", material);
    chooseKind(record, material);
    if (material.kind != MaterialKind::ThinGlass && material.kind != MaterialKind::Mirror) {
        material.reflectanceTexture = loadMap(record.mapKd, material);
        if (material.reflectanceTexture.used() && material.reflectance.isBlack()) {
            material.reflectance = Rgb{1.0F};
            warn(material, "has a map_Kd but a black Kd: the picture is taken as it is");
        }
    }
    if (record.ke) {
        const Rgb& ke = *record.ke;
        material.emission = {std::max(ke.r, 0.0F), std::max(ke.g, 0.0F), std::max(ke.b, 0.0F)};
        if (material.emission != ke) warn(material, "Ke is negative, taken as 0");
    }
    if (material.emits()) material.emissionTexture = loadMap(record.mapKe, material);
    return material;
}

void MaterialLibrary::chooseKind(const MtlRecord& record, Material& material) {
    const bool clear = record.dissolve < 1 || record.tf.has_value();
    if (isTransparentModel(record.illum) && clear) {
        material.kind = MaterialKind::ThinGlass;
        material.ior = static_cast<float>(std::clamp(record.ior, 1.0, 3.0));
        const double r = (material.ior - 1) / (material.ior + 1), f0 = r * r;
        // Both faces reflect: a pane that absorbs nothing lets (1 - F) / (1 + F) through.
        const double passes = (record.dissolve < 1 ? std::clamp(1 - record.dissolve, 0.0, 1.0) : 1.0) * (1 - f0) / (1 + f0);
        material.transmittance = reflectance(record.tf.value_or(Rgb{1.0F}), "Tf", material) * static_cast<float>(passes);
        material.reflectance = Rgb{0.0F};
        warn(material, fmt::format("illum {} is approximated by a pane without thickness", record.illum));
        return;
    }
    if (record.dissolve < 1)
        warn(material, fmt::format("d {:g} without a glass illum (4, 6, 7, 9) is left out: the surface is taken as opaque", record.dissolve));
    if (record.pr || record.pm) {
        material.kind = MaterialKind::MetallicRoughness;
        material.roughness = static_cast<float>(std::clamp(record.pr.value_or(0.5), 0.0, 1.0));
        material.metallic = static_cast<float>(std::clamp(record.pm.value_or(0.0), 0.0, 1.0));
        material.specular = Rgb{0.04F};
        return;
    }
    if (material.specular.isBlack() || record.illum == 0 || record.illum == 1) return;  // Matte
    material.roughness = roughnessOf(record.ns);
    const bool noDiffuse = material.reflectance.isBlack() && !record.mapKd;
    if (noDiffuse && isMirrorModel(record.illum)) {
        material.kind = MaterialKind::Mirror;
    } else if (noDiffuse) {
        material.kind = MaterialKind::Metal;
    } else {
        material.kind = MaterialKind::Plastic;
        limitSpecular(material);
    }
}

void MaterialLibrary::limitSpecular(Material& material) {
    // Phong's Ks was never a reflectance: together with Kd it must not give back more light than comes.
    const float excess = (material.reflectance + material.specular).max();
    if (excess <= 1) return;
    const float left = 1 - material.reflectance.max();
    const float factor = left / material.specular.max();
    warn(material, fmt::format("Kd + Ks reaches {:g}: Ks is scaled by {:.3g}", excess, std::min(factor, 1.0F)));
    material.specular *= std::min(factor, 1.0F);
}

}  // namespace luxdeck::obj
