#include "engine/transport/chance_light.h"

#include <fmt/format.h>

#include <map>

namespace luxdeck {

namespace {

bool turnsLight(const Material& m) {
    switch (m.kind) {
        case MaterialKind::Mirror:
        case MaterialKind::Dielectric: return true;
        case MaterialKind::ThinGlass: return m.ior > 1;
        case MaterialKind::Ward: return m.wardPerfect() && !m.specular.isBlack();
        default: return false;
    }
}

/// The lights that are small enough to be missed; empty: none.
std::string smallLights(const Scene& scene) {
    std::size_t lit = 0;
    for (const auto& l : scene.luminaires) lit += l.outputScale() > 0 ? 1 : 0;
    std::vector<std::string> kinds;
    if (!scene.sky.suns.empty()) kinds.emplace_back(scene.sky.suns.size() > 1 ? "the suns" : "the sun");
    if (lit > 0) kinds.push_back(lit > 1 ? fmt::format("{} luminaires", lit) : std::string("a luminaire"));
    bool emits = false;
    for (const auto& mesh : scene.meshes) {
        const auto& m = scene.materials[mesh.material];
        emits = emits || (m.emits() && m.emissionLights && !mesh.triangles.empty());
    }
    if (emits) kinds.emplace_back("emitting surfaces");
    return fmt::format("{}", fmt::join(kinds, ", "));
}

const char* wayOf(const Material& m) {
    return m.kind == MaterialKind::Dielectric ? "through this solid, which bends it," : "mirrored in it";
}

/// More lines would hide the rest.
constexpr std::size_t kMostLines = 8;

}  // namespace

bool leftToChance(const TransportScene& scene, std::uint32_t mesh, std::uint32_t triangle) {
    const auto& material = scene.scene.materials[scene.scene.meshes[mesh].material];
    return turnsLight(material) && scene.mirrors.of(mesh, triangle) == kNoMirror;
}

std::vector<std::string> chanceLightWarnings(const TransportScene& scene) {
    const auto lights = smallLights(scene.scene);
    std::vector<std::string> out;
    if (lights.empty() || !(scene.needs.specularChains || scene.needs.dielectrics)) return out;
    std::map<std::uint32_t, std::uint32_t> objectOf;  // by material: the first that has such a triangle
    for (std::uint32_t m = 0; m < scene.scene.meshes.size(); ++m)
        for (std::uint32_t t = 0; t < scene.scene.meshes[m].triangles.size(); ++t)
            if (leftToChance(scene, m, t)) {
                objectOf.try_emplace(scene.scene.meshes[m].material, scene.scene.meshes[m].object);
                break;
            }
    for (const auto& [material, object] : objectOf) {
        if (out.size() == kMostLines) {
            out.push_back(fmt::format("and {} more such materials", objectOf.size() - kMostLines));
            break;
        }
        const auto& m = scene.scene.materials[material];
        out.push_back(fmt::format("material \"{}\" (object \"{}\"): light {} is met by chance alone ({}); the intervals hold what was not met "
                                  "(docs/decisions/0012)", m.name, scene.scene.objects[object].name, wayOf(m), lights));
    }
    return out;
}

}  // namespace luxdeck
