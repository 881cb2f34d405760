#include "engine/io/project_keys.h"
#include "engine/io/project_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace luxdeck::project {

namespace {

/// A kind of material with the keys that mean something for it, the first of which it must have.
struct KindKeys {
    std::string_view name;
    MaterialKind kind;
    std::vector<std::string_view> keys;
};

const std::vector<KindKeys>& kinds() {
    static const std::vector<KindKeys> kKinds = {
        {"matte", MaterialKind::Matte, {"reflectance"}},
        {"plastic", MaterialKind::Plastic, {"reflectance", "specular", "roughness"}},
        {"metal", MaterialKind::Metal, {"specular", "roughness"}},
        {"mirror", MaterialKind::Mirror, {"specular"}},
        {"glass", MaterialKind::ThinGlass, {"transmittance", "ior"}},
        {"metallic-roughness", MaterialKind::MetallicRoughness, {"reflectance", "metallic", "roughness"}},
        {"ward", MaterialKind::Ward, {"reflectance", "specular", "roughness_u", "roughness_v", "grain"}},
        {"trans",
         MaterialKind::Ward,
         {"reflectance", "specular", "diffuse_transmittance", "specular_transmittance", "roughness_u", "roughness_v", "grain"}},
        {"dielectric", MaterialKind::Dielectric, {"ior", "transmittance_per_metre"}}};
    return kKinds;
}

constexpr Key kKindKeys[] = {"reflectance",   "specular",    "roughness",   "metallic", "transmittance", "ior",
                             "roughness_u",   "roughness_v", "grain",       "diffuse_transmittance",
                             "specular_transmittance",       "transmittance_per_metre"};

// A surface that returns all light makes a closed room's light infinite.
constexpr NumberRange kReflectance{.low = 0, .high = 1, .highExcluded = true};
constexpr float kDoubtfulReflectance = 0.999F;
constexpr NumberRange kEmission{.low = 0, .high = 1e12};  // the sun's disc has 2e9 cd/m^2
constexpr NumberRange kIor{.low = 1, .high = 4};
constexpr double kPaneRounding = 0.005;  // data sheets give two or three digits

const KindKeys& kindOf(const TomlTable& table) {
    std::vector<TomlChoice<const KindKeys*>> choices;
    for (const auto& kind : kinds()) choices.push_back({kind.name, &kind});
    return *table.choice<const KindKeys*>("kind", &kinds().front(), choices);
}

void refuseForeignKeys(const TomlTable& table, const KindKeys& kind) {
    const auto belongs = [](const KindKeys& k, Key key) {
        return std::find(k.keys.begin(), k.keys.end(), key) != k.keys.end();
    };
    for (const auto key : kKindKeys) {
        if (!table.has(key) || belongs(kind, key)) continue;
        std::string owners;
        for (const auto& k : kinds())
            if (belongs(k, key)) owners += fmt::format("{}{}", owners.empty() ? "" : ", ", k.name);
        table.error(ErrorCode::InvalidArgument, key,
                    fmt::format("{} has no meaning for kind \"{}\", which is described by {}; it belongs to {}", key,
                                kind.name, fmt::join(kind.keys, ", "), owners));
    }
}

Rgb readReflectance(const TomlTable& table, Key key, const Rgb& fallback) {
    const auto colour = table.colour(key, kReflectance, fallback);
    if (colour.max() > kDoubtfulReflectance)
        table.warn(key, fmt::format("{} is {}: no real surface reflects so much, and light settles slowly", key, colour.max()));
    return colour;
}

/// A pane without absorption lets (1 - r) / (1 + r) through, with r from Fresnel at normal incidence; more would
/// need glass that shines.
Rgb readTransmittance(const TomlTable& table, float ior) {
    auto colour = table.colour("transmittance", kFraction);
    const double root = (ior - 1.0) / (ior + 1.0), r = root * root;
    const double clear = (1.0 - r) / (1.0 + r);
    if (colour.max() <= clear) return colour;
    const auto what = fmt::format("transmittance is {}, a clear pane of ior {} lets through {:.3f}", colour.max(), ior, clear);
    if (colour.max() > clear + kPaneRounding)
        table.error(ErrorCode::InvalidArgument, "transmittance", what);
    else
        table.warn("transmittance", what + ": lowered to that");
    const auto most = static_cast<float>(clear);
    return {std::min(colour.r, most), std::min(colour.g, most), std::min(colour.b, most)};
}

/// Ward surfaces: what they reflect and let through makes at most the whole; the widths are both zero or none.
void readWard(const TomlTable& table, Material& m) {
    if (!table.has("specular")) m.specular = Rgb(0.0F);
    m.diffuseTransmittance = table.colour("diffuse_transmittance", kFraction, Rgb{});
    m.specularTransmittance = table.colour("specular_transmittance", kFraction, Rgb{});
    m.wardU = static_cast<float>(table.number("roughness_u", kFraction, 0));
    m.wardV = static_cast<float>(table.number("roughness_v", kFraction, m.wardU));
    m.grain = Vec3(table.vector("grain", Vec3d(0, 0, 0)));
    if ((m.wardU == 0) != (m.wardV == 0))
        table.error(ErrorCode::InvalidArgument, "roughness_v",
                    fmt::format("roughness_u is {} and roughness_v {}, expected both 0 or none", m.wardU, m.wardV));
    const Rgb sum = m.reflectance + m.specular + m.diffuseTransmittance + m.specularTransmittance;
    if (sum.max() > 1 + 1e-5F)  // decimal fractions that sum to 1 may round above it
        table.error(ErrorCode::InvalidArgument, "reflectance",
                    fmt::format("what is reflected and let through sums to {}, expected at most 1", sum.max()));
}

std::vector<std::string> materialNames(const Scene& scene) {
    std::vector<std::string> names;
    for (const auto& material : scene.materials) names.push_back(material.name);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

}  // namespace

std::vector<MaterialSpec> readMaterials(const TomlTable& root) {
    std::vector<MaterialSpec> materials;
    UniqueNames names;
    root.each("material", kMaterial, [&](const TomlTable& table) {
        Material m;
        m.name = table.text("name");
        names.add(table, "name", m.name);
        const auto& kind = kindOf(table);
        m.kind = kind.kind;
        refuseForeignKeys(table, kind);
        if (!table.has(kind.keys.front()))
            table.error(ErrorCode::Parse, "", fmt::format("{} is missing: kind \"{}\" needs it", kind.keys.front(), kind.name));
        m.reflectance = readReflectance(table, "reflectance", m.reflectance);
        m.specular = readReflectance(table, "specular", m.specular);
        m.roughness = static_cast<float>(table.number("roughness", kFraction, m.roughness));
        m.metallic = static_cast<float>(table.number("metallic", kFraction, m.metallic));
        m.ior = static_cast<float>(table.number("ior", kIor, m.ior));
        if (table.has("transmittance")) m.transmittance = readTransmittance(table, m.ior);
        if (m.kind == MaterialKind::Ward) readWard(table, m);
        if (m.kind == MaterialKind::Dielectric)
            m.transmittance = table.colour("transmittance_per_metre", kFraction, Rgb(1.0F));
        m.emission = table.colour("emission_cd_m2", kEmission, Rgb{});
        m.source = table.text("source", "");
        materials.push_back({std::move(m), table.where("name")});
    });
    return materials;
}

Result<void> replaceMaterials(Scene& scene, const std::vector<MaterialSpec>& materials) {
    for (const auto& spec : materials) {
        bool found = false;
        for (auto& material : scene.materials) {
            if (material.name != spec.material.name) continue;
            material = spec.material;
            found = true;
        }
        if (!found)
            return Error{ErrorCode::InvalidArgument,
                         fmt::format("[[material]] {}: no material of that name in the geometry; {}",
                                     inQuotes(spec.material.name), suggestion(spec.material.name, materialNames(scene))),
                         spec.where};
    }
    return {};
}

}  // namespace luxdeck::project
