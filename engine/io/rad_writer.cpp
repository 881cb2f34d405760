#include "engine/io/rad_writer.h"

#include "engine/core/primaries.h"
#include "engine/io/rad_material.h"
#include "engine/io/rad_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace luxdeck {

namespace {

/// A name that is one word of Radiance's.
std::string wordOf(const std::string& name, const char* otherwise) {
    std::string word;
    for (const char c : name) word += std::isspace(static_cast<unsigned char>(c)) != 0 || c == '"' || c == '\'' || c == '#' || c == '!' ? '_' : c;
    return word.empty() || word == "void" ? otherwise : word;
}

class Writer {
public:
    explicit Writer(const Scene& scene)
        : scene_(scene), toRadiance_(rgbToRgb(chromaticitiesOf(scene.weights), chromaticitiesOf(kRadianceWeights))), same_(scene.weights == kRadianceWeights) {}

    RadText write() {
        for (const auto& m : scene_.materials) materials_.push_back(uniqueName(m.name));
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) material(i);
        for (const auto& mesh : scene_.meshes) geometry(mesh);
        sky();
        if (!scene_.luminaires.empty()) lose(fmt::format("{} luminaires: ies2rad makes them of their photometric files", scene_.luminaires.size()));
        if (std::any_of(scene_.meshes.begin(), scene_.meshes.end(), [](const auto& m) { return !m.normals.empty(); })) lose("smooth normals: triangles are flat");
        return std::move(out_);
    }

private:
    void lose(const std::string& text) {
        if (std::find(out_.lost.begin(), out_.lost.end(), text) == out_.lost.end()) out_.lost.push_back(text);
    }
    std::string uniqueName(const std::string& name) {
        const auto stem = wordOf(name, "material");
        auto unique = stem;
        for (int i = 2; !taken_.insert(unique).second; ++i) unique = fmt::format("{}_{}", stem, i);
        return unique;
    }
    [[nodiscard]] Rgb converted(const Rgb& c) const { return same_ ? c : transformed(c, toRadiance_); }
    [[nodiscard]] Rgb fraction(const Rgb& colour) const {
        const Rgb c = converted(colour);
        return {std::clamp(c.r, 0.0F, 1.0F), std::clamp(c.g, 0.0F, 1.0F), std::clamp(c.b, 0.0F, 1.0F)};
    }
    static std::string numbers(const Rgb& c) { return fmt::format("{} {} {}", c.r, c.g, c.b); }
    [[nodiscard]] float brightness(const Rgb& c) const { return luminance(c, kRadianceWeights); }

    void add(const char* type, const std::string& name, const std::string& strings, const std::string& reals) {
        const auto count = [](const std::string& text) {
            return text.empty() ? 0 : 1 + std::count(text.begin(), text.end(), ' ');
        };
        out_.materials += fmt::format("void {} {}\n{}{}{}\n0\n{} {}\n\n", type, name, count(strings), strings.empty() ? "" : " ", strings, count(reals), reals);
    }

    void noteLosses(const Material& m, const std::string& name) {
        if (m.reflectanceTexture.used() || m.metallicRoughnessTexture.used() || m.emissionTexture.used()) lose(fmt::format("the textures of {}", name));
        if (m.reflectancePattern >= 0 || m.emissionPattern >= 0) lose(fmt::format("the pattern of {}", name));
        if (m.hasHoles()) lose(fmt::format("the holes of {}", name));
        if (m.emits() && !m.oneSidedEmission) lose(fmt::format("what {} emits on its back", name));
        if (m.emits() && !m.reflectance.isBlack()) lose(fmt::format("what {} reflects: it emits", name));
    }

    void material(std::size_t index) {
        const auto& m = scene_.materials[index];
        const auto& name = materials_[index];
        noteLosses(m, name);
        if (m.emits()) {
            const Rgb c = converted(m.emission);
            const auto radiance = [](float x) { return std::max(0.0, x / rad::kLumensPerWatt); };
            return add("light", name, "", fmt::format("{} {} {}", radiance(c.r), radiance(c.g), radiance(c.b)));
        }
        switch (m.kind) {
            case MaterialKind::Matte: return add("plastic", name, "", numbers(fraction(m.reflectance)) + " 0 0");
            case MaterialKind::Plastic: return coated(m, name, m.reflectance);
            case MaterialKind::Metal: return add("metal", name, "", fmt::format("{} 1 {}", numbers(fraction(m.specular)), m.roughness * m.roughness));
            case MaterialKind::Mirror: return add("mirror", name, "", numbers(fraction(m.specular)));
            case MaterialKind::ThinGlass: return glass(m, name);
            case MaterialKind::MetallicRoughness:
                if (m.metallic > 0.5F) return add("metal", name, "", fmt::format("{} 1 {}", numbers(fraction(m.reflectance)), m.roughness * m.roughness));
                return coated(m, name, m.reflectance * (1 - m.metallic));
            case MaterialKind::Ward: return ward(m, name);
            case MaterialKind::Dielectric: return add("dielectric", name, "", fmt::format("{} {} 0", numbers(fraction(m.transmittance)), m.ior));
            case MaterialKind::Mix:
                lose(fmt::format("the mixture {}: taken as half grey", name));
                return add("plastic", name, "", "0.5 0.5 0.5 0 0");
        }
    }

    void coated(const Material& m, const std::string& name, const Rgb& reflectance) {
        lose("the increase of coats towards grazing directions is Radiance's own");
        add("plastic", name, "", fmt::format("{} {} {}", numbers(fraction(reflectance)), brightness(fraction(m.specular)), m.roughness * m.roughness));
    }

    void glass(const Material& m, const std::string& name) {
        const Rgb t = fraction(m.transmittance);
        const auto inner = [&](float x) { return std::min(1.0, rad::paneTransmissivity(x, m.ior)); };
        add("glass", name, "", fmt::format("{} {} {} {}", inner(t.r), inner(t.g), inner(t.b), m.ior));
    }

    /// Of reflectance C (1 - s)(1 - T), transmittances C (1 - s) T (1 - t) and C (1 - s) T t, and the lobe s or, of a
    /// metal, C s: the numbers that make them.
    void ward(const Material& m, const std::string& name) {
        const Rgb diffuse = fraction(m.reflectance), specular = fraction(m.specular);
        const Rgb scattered = fraction(m.diffuseTransmittance), straight = fraction(m.specularTransmittance);
        const Rgb through = scattered + straight;
        const bool two = m.wardU != m.wardV;
        const auto grain = two ? fmt::format("{} {} {} .", m.grain.x, m.grain.y, m.grain.z) : std::string();
        const auto widths = two ? fmt::format("{} {}", m.wardU, m.wardV) : fmt::format("{}", m.wardU);
        if (two && m.grain.length() == 0) lose(fmt::format("the grain of {}", name));
        const auto ratio = [this](const Rgb& part, const Rgb& whole) { return whole.isBlack() ? 0.0F : brightness(part) / brightness(whole); };
        if (through.isBlack() && !specular.isGrey()) {
            const Rgb whole = diffuse + specular;
            return add(two ? "metal2" : "metal", name, grain, fmt::format("{} {} {}", numbers(whole), ratio(specular, whole), widths));
        }
        const float s = brightness(specular);
        const Rgb whole = (diffuse + through) * (1 / std::max(1 - s, 1e-6F));
        const auto first = fmt::format("{} {} {}", numbers({std::min(whole.r, 1.0F), std::min(whole.g, 1.0F), std::min(whole.b, 1.0F)}), s, widths);
        if (through.isBlack()) return add(two ? "plastic2" : "plastic", name, grain, first);
        add(two ? "trans2" : "trans", name, grain, fmt::format("{} {} {}", first, ratio(through, diffuse + through), ratio(straight, through)));
    }

    [[nodiscard]] std::string corner(const Vec3& p) const {
        if (scene_.origin == Vec3d(0, 0, 0)) return fmt::format("{} {} {}", p.x, p.y, p.z);  // the shortest text that reads as the same float
        const Vec3d user = scene_.toUser(p);
        return fmt::format("{} {} {}", user.x, user.y, user.z);
    }

    void geometry(const Mesh& mesh) {
        const auto& material = materials_[mesh.material];
        const auto name = wordOf(scene_.objects[mesh.object].name, "object");
        auto to = std::back_inserter(out_.geometry);
        for (const auto& t : mesh.triangles)
            fmt::format_to(to, "{} polygon {}.{}\n0\n0\n9 {}  {}  {}\n\n", material, name, ++triangles_, corner(mesh.positions[t[0]]),
                           corner(mesh.positions[t[1]]), corner(mesh.positions[t[2]]));
    }

    void addSource(const std::string& name, const Rgb& radianceCdM2, const Vec3& direction, double angleDeg) {
        const Rgb c = converted(radianceCdM2) * static_cast<float>(1 / rad::kLumensPerWatt);
        out_.sky += fmt::format("void {} {}_light\n0\n0\n{} {} {} {}{}\n\n{}_light source {}\n0\n0\n4 {} {} {} {}\n\n", angleDeg < 90 ? "light" : "glow", name,
                                angleDeg < 90 ? 3 : 4, c.r, c.g, c.b, angleDeg < 90 ? "" : " 0", name, name, direction.x, direction.y, direction.z, angleDeg);
    }

    /// As gensky writes it: type 2 of skybright.cal, with the radiances of zenith and ground.
    void addOvercast() {
        const double zenith = scene_.sky.zenithCdM2 / rad::kLumensPerWatt;
        const double ground = luminance(scene_.sky.radiance({0, 0, -1}), scene_.weights) / rad::kLumensPerWatt;
        out_.sky += fmt::format("void brightfunc skyfunc\n2 skybr skybright.cal\n0\n3 2 {} {}\n\nskyfunc glow sky_light\n0\n0\n4 {} 0\n\nsky_light source sky\n0\n0\n4 0 0 1 180\n\n",
                                zenith, ground, numbers(converted(scene_.sky.colour)));
    }

    void sky() {
        const auto& sky = scene_.sky;
        int suns = 0, domes = 0;
        for (const auto& sun : sky.suns) addSource(fmt::format("sun{}", ++suns), sun.radiance, sun.direction, 2 * sun.halfAngleRad / kDegree);
        for (const auto& dome : sky.domes) {
            if (dome.pattern) lose("a dome of the sky with a pattern: gensky or gendaylit makes it");
            else addSource(fmt::format("dome{}", ++domes), dome.radiance, dome.direction, 2 * dome.halfAngleRad / kDegree);
        }
        if (sky.kind == SkyKind::None || !(sky.zenithCdM2 > 0)) return;
        if (sky.kind == SkyKind::Uniform) addSource("sky", sky.colour * static_cast<float>(sky.zenithCdM2), {0, 0, 1}, 180);
        else if (sky.kind == SkyKind::CieOvercast) addOvercast();
        else return lose("the sky: gensky or gendaylit makes it");
        addSource("ground", sky.radiance({0, 0, -1}), {0, 0, -1}, 180);
    }

    const Scene& scene_;
    Imath::M33d toRadiance_;
    bool same_;
    RadText out_;
    std::set<std::string> taken_;
    std::vector<std::string> materials_;
    std::size_t triangles_ = 0;
};

}  // namespace

RadText writeRad(const Scene& scene) { return Writer(scene).write(); }

std::string writePoints(std::span<const Vec3d> points, std::span<const Vec3d> normals) {
    std::string text;
    for (std::size_t i = 0; i < points.size() && i < normals.size(); ++i)
        text += fmt::format("{} {} {} {} {} {}\n", points[i].x, points[i].y, points[i].z, normals[i].x, normals[i].y, normals[i].z);
    return text;
}

}  // namespace luxdeck
