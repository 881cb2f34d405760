#include "engine/scene/scene.h"

#include "engine/core/file.h"
#include "engine/scene/content_parts.h"
#include "engine/scene/duplicates.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <type_traits>

namespace luxdeck {

std::size_t Scene::triangleCount() const {
    std::size_t count = 0;
    for (const auto& mesh : meshes) count += mesh.triangles.size();
    return count;
}

bool Scene::letsStraightThrough(const Material& m) const {
    if (m.hasHoles() || m.kind == MaterialKind::ThinGlass) return true;
    if (m.kind == MaterialKind::Ward) return m.wardPerfect() && !m.specularTransmittance.isBlack();
    if (m.kind != MaterialKind::Mix) return false;
    return letsStraightThrough(materials[m.mixFirst]) || letsStraightThrough(materials[m.mixSecond]);
}

Box3 Scene::bounds() const {
    Box3 box;
    for (const auto& mesh : meshes)
        for (const auto& p : mesh.positions) box.extendBy(p);
    for (const auto& luminaire : luminaires) box.extendBy(luminaire.position);
    return box;
}

namespace {

Error invalid(std::string where, std::string message) {
    return {ErrorCode::InvalidArgument, std::move(message), std::move(where)};
}

Result<void> checkFraction(const std::string& where, const char* what, const Rgb& c) {
    if (!isFinite(c) || c.min() < 0.0F || c.max() > 1.0F)
        return invalid(where, fmt::format("{} is ({}, {}, {}), expected fractions 0..1", what, c.r, c.g, c.b));
    return {};
}

/// Widths, the grain, and what a Ward surface gives back in all.
Result<void> checkWard(const Material& m, const std::string& where) {
    if (!isFinite(m.grain)) return invalid(where, "grain is not a finite direction");
    if (m.kind != MaterialKind::Ward) return {};
    if ((m.wardU == 0) != (m.wardV == 0))
        return invalid(where, fmt::format("ward widths are {} and {}, expected both zero or none", m.wardU, m.wardV));
    const Rgb sum = m.reflectance + m.specular + m.diffuseTransmittance + m.specularTransmittance;
    if (sum.max() > 1 + 1e-5F)  // decimal fractions that sum to 1 may round above it
        return invalid(where, fmt::format("reflectance, specular and both transmittances sum to ({}, {}, {}), expected at most 1",
                                          sum.r, sum.g, sum.b));
    return {};
}

Result<void> checkPattern(const std::string& where, const char* what, std::int32_t pattern, const Scene& scene) {
    if (pattern >= static_cast<std::int32_t>(scene.patterns.size()))
        return invalid(where, fmt::format("{} {}, expected one below {}", what, pattern, scene.patterns.size()));
    return {};
}

Result<void> checkMix(const Material& m, const std::string& where, const Scene& scene) {
    if (m.kind != MaterialKind::Mix) return {};
    if (m.mixPattern < 0) return invalid(where, "a mixture without a pattern, expected one that says how much of each");
    if (m.emits()) return invalid(where, "a mixture that emits, expected emission in what is mixed");
    for (const auto part : {m.mixFirst, m.mixSecond}) {
        if (part >= scene.materials.size())
            return invalid(where, fmt::format("mixes material {}, expected one below {}", part, scene.materials.size()));
        const auto kind = scene.materials[part].kind;
        if (kind == MaterialKind::Mix || kind == MaterialKind::Dielectric)
            return invalid(where, fmt::format("mixes material {}, which is a {}, expected a surface of its own", part,
                                              kind == MaterialKind::Mix ? "mixture" : "solid"));
    }
    return {};
}

Result<void> checkMaterial(const Material& m, std::size_t index, const Scene& scene) {
    const auto where = fmt::format("material {} \"{}\"", index, m.name);
    const auto textureCount = scene.textures.size();
    for (const auto& [what, colour] :
         {std::pair{"reflectance", m.reflectance}, std::pair{"specular", m.specular}, std::pair{"transmittance", m.transmittance},
          std::pair{"diffuse transmittance", m.diffuseTransmittance}, std::pair{"specular transmittance", m.specularTransmittance}})
        if (auto ok = checkFraction(where, what, colour); !ok) return ok;
    for (const auto& [what, pattern] : {std::pair{"reflectance pattern", m.reflectancePattern},
                                        std::pair{"emission pattern", m.emissionPattern}, std::pair{"mix pattern", m.mixPattern}})
        if (auto ok = checkPattern(where, what, pattern, scene); !ok) return ok;
    if (auto ok = checkWard(m, where); !ok) return ok;
    if (auto ok = checkMix(m, where, scene); !ok) return ok;
    if (!(m.alphaCutoff >= 0.0F && std::isfinite(m.alphaCutoff)))
        return invalid(where, fmt::format("alpha cutoff is {}, expected a finite value >= 0", m.alphaCutoff));
    if (m.hasHoles() && m.kind == MaterialKind::Dielectric)
        return invalid(where, "the surface of a solid has holes, expected a closed one");
    for (const auto& [what, value] : {std::pair{"roughness", m.roughness}, std::pair{"metallic", m.metallic},
                                      std::pair{"alpha", m.alpha}, std::pair{"ward width along the grain", m.wardU},
                                      std::pair{"ward width across the grain", m.wardV}})
        if (!(value >= 0.0F && value <= 1.0F))
            return invalid(where, fmt::format("{} is {}, expected 0..1", what, value));
    if (!(m.ior >= 1.0F && m.ior <= 4.0F)) return invalid(where, fmt::format("ior is {}, expected 1..4", m.ior));
    if (!isFinite(m.emission) || m.emission.min() < 0.0F)
        return invalid(where, fmt::format("emission is ({}, {}, {}) cd/m^2, expected finite values >= 0",
                                          m.emission.r, m.emission.g, m.emission.b));
    for (const auto* slot : {&m.reflectanceTexture, &m.metallicRoughnessTexture, &m.emissionTexture})
        if (slot->texture >= static_cast<std::int32_t>(textureCount))
            return invalid(where, fmt::format("texture {}, expected one below {}", slot->texture, textureCount));
    return {};
}

bool isDegenerate(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    return !((b - a).cross(c - a).length2() > 0.0);
}

Result<void> checkMesh(const Mesh& mesh, std::size_t index, const Scene& scene) {
    const auto where = fmt::format("mesh {} \"{}\"", index, mesh.name);
    if (mesh.material >= scene.materials.size())
        return invalid(where, fmt::format("material {}, expected one below {}", mesh.material, scene.materials.size()));
    if (mesh.object >= scene.objects.size())
        return invalid(where, fmt::format("object {}, expected one below {}", mesh.object, scene.objects.size()));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (!isFinite(mesh.positions[i]))
            return invalid(where, fmt::format("vertex {} is ({}, {}, {}), expected finite coordinates", i,
                                              mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z));
    const auto count = mesh.positions.size();
    if ((!mesh.normals.empty() && mesh.normals.size() != count) || (!mesh.uvs.empty() && mesh.uvs.size() != count))
        return invalid(where, fmt::format("{} normals and {} texture coordinates for {} vertices", mesh.normals.size(),
                                          mesh.uvs.size(), count));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const auto vertex : mesh.triangles[i])
            if (vertex >= count)
                return invalid(where, fmt::format("triangle {} names vertex {}, expected one below {}", i, vertex, count));
    return {};
}

Result<void> checkLuminaire(const Luminaire& l, std::size_t index, const Scene& scene) {
    const auto where = fmt::format("luminaire {} \"{}\"", index, l.name);
    if (l.type >= scene.luminaireTypes.size())
        return invalid(where, fmt::format("type {}, expected one below {}", l.type, scene.luminaireTypes.size()));
    if (!isFinite(l.position) || !isFinite(l.frame.tangent) || !isFinite(l.frame.normal))
        return invalid(where, "position or aim is not finite");
    if (!std::isfinite(l.outputScale()) || l.outputScale() < 0)
        return invalid(where, fmt::format("output scale is {}, expected a finite value >= 0", l.outputScale()));
    return {};
}

/// Appends the bytes of plain values to what is hashed.
class HashInput {
public:
    template <class T>  // Imath's vectors are plain values, though not trivially copyable to the letter
        requires(std::is_standard_layout_v<T> && std::is_trivially_destructible_v<T>)
    void add(const T& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <class T>
    void addAll(const std::vector<T>& values) {
        add(values.size());
        bytes_ += contentHash({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
    }
    [[nodiscard]] std::string hash() const { return contentHash(bytes_); }

private:
    std::string bytes_;
};

void addSlot(HashInput& in, const TextureSlot& s) {
    in.add(s.texture), in.add(s.offset), in.add(s.scale), in.add(s.rotation);
}

void addMaterial(HashInput& in, const Material& m) {
    in.add(m.kind), in.add(m.reflectance), in.add(m.specular), in.add(m.roughness), in.add(m.metallic);
    in.add(m.transmittance), in.add(m.ior), in.add(m.emission), in.add(m.oneSidedEmission);
    if (!m.emissionLights) in.add(m.emissionLights);  // hashes of scenes without such stay
    in.add(m.wardU), in.add(m.wardV), in.add(m.grain), in.add(m.diffuseTransmittance), in.add(m.specularTransmittance);
    in.add(m.alpha), in.add(m.alphaCutoff), in.add(m.alphaBlend), in.add(m.reflectancePattern), in.add(m.emissionPattern);
    in.add(m.mixPattern), in.add(m.mixFirst), in.add(m.mixSecond);
    for (const auto* slot : {&m.reflectanceTexture, &m.metallicRoughnessTexture, &m.emissionTexture}) addSlot(in, *slot);
}

}  // namespace

Result<void> validate(Scene& scene) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        if (auto ok = checkMaterial(scene.materials[i], i, scene); !ok) return ok;
    for (std::size_t i = 0; i < scene.luminaires.size(); ++i)
        if (auto ok = checkLuminaire(scene.luminaires[i], i, scene); !ok) return ok;
    std::size_t dropped = 0;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        auto& mesh = scene.meshes[i];
        if (auto ok = checkMesh(mesh, i, scene); !ok) return ok;
        dropped += std::erase_if(mesh.triangles, [&](const auto& t) { return isDegenerate(mesh, t); });
    }
    if (dropped > 0)
        scene.warnings.push_back(fmt::format("{} triangles without area were left out: they reflect and hide nothing", dropped));
    if (const auto twice = removeCoincidentEmitters(scene); twice > 0)
        scene.warnings.push_back(fmt::format("{} emitting triangles lie exactly on others and were left out: they would shine twice", twice));
    return {};
}

namespace {

void addMesh(HashInput& in, const Mesh& mesh) {
    in.addAll(mesh.positions), in.addAll(mesh.normals), in.addAll(mesh.uvs), in.addAll(mesh.triangles);
    in.add(mesh.material);
}

void addPictures(HashInput& in, const Scene& scene) {
    for (const auto& p : scene.patterns) {
        const auto identity = p->identity();
        in.addAll(std::vector<char>(identity.begin(), identity.end()));
    }
    for (const auto& t : scene.textures) {
        in.add(t.width), in.add(t.height), in.add(t.srgb), in.add(t.wrapU), in.add(t.wrapV);
        in.addAll(t.rgba);
    }
}

void addLuminaireType(HashInput& in, const LuminaireType& t) {
    const auto& table = t.photometry.table;
    in.add(table.type()), in.addAll(table.vertical()), in.addAll(table.horizontal()), in.addAll(table.candela());
    const auto& opening = t.photometry.opening;  // field by field: the bytes between them are anything
    in.add(t.colour), in.add(opening.shape), in.add(opening.lengthM), in.add(opening.widthM), in.add(opening.heightM);
}

void addLuminaire(HashInput& in, const Luminaire& l) {
    in.add(l.position), in.add(l.frame), in.add(l.outputScale());
}

void addSky(HashInput& in, const Sky& sky) {
    const auto identity = sky.identity();
    in.addAll(std::vector<char>(identity.begin(), identity.end()));
}

std::string nameOr(const std::string& name, const char* kind, std::size_t index) {
    return name.empty() ? fmt::format("{} {}", kind, index + 1) : fmt::format("{} {}", kind, name);
}

}  // namespace

std::string sceneHash(const Scene& scene) {
    HashInput in;
    in.add(scene.origin);
    for (const auto& mesh : scene.meshes) addMesh(in, mesh);
    for (const auto& m : scene.materials) addMaterial(in, m);
    addPictures(in, scene);
    for (const auto& t : scene.luminaireTypes) addLuminaireType(in, t);
    for (const auto& l : scene.luminaires) in.add(l.type), addLuminaire(in, l);
    addSky(in, scene.sky);
    in.add(scene.weights);
    return in.hash();
}

std::vector<ContentPart> contentParts(const Scene& scene) {
    std::vector<ContentPart> parts;
    std::vector<HashInput> objects(scene.objects.size());
    std::vector<Box3> boxes(scene.objects.size());
    for (const auto& mesh : scene.meshes) {
        auto& in = objects[mesh.object];
        addMesh(in, mesh), addMaterial(in, scene.materials[mesh.material]);
        for (const auto& p : mesh.positions) boxes[mesh.object].extendBy(p);
    }
    for (std::size_t i = 0; i < objects.size(); ++i) parts.push_back({nameOr(scene.objects[i].name, "object", i), objects[i].hash(), boxes[i]});
    std::vector<HashInput> types(scene.luminaireTypes.size());
    for (std::size_t i = 0; i < types.size(); ++i) addLuminaireType(types[i], scene.luminaireTypes[i]);
    for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
        const auto& l = scene.luminaires[i];
        auto in = types[l.type];
        addLuminaire(in, l);
        parts.push_back({nameOr(l.name, "luminaire", i), in.hash(), Box3(l.position, l.position)});
    }
    HashInput sky, pictures, space;
    addSky(sky, scene.sky), addPictures(pictures, scene), space.add(scene.origin), space.add(scene.weights);
    parts.push_back({"sky", sky.hash(), {}});
    parts.push_back({"textures and patterns", pictures.hash(), {}});
    parts.push_back({"origin or colour space", space.hash(), {}});
    return parts;
}

}  // namespace luxdeck
