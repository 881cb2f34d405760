#include "engine/transport/enclosure.h"

#include "engine/core/rng.h"
#include "engine/sampling/warp.h"
#include "engine/transport/surface/glass.h"
#include "engine/transport/surface/surface_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace luxdeck {

namespace {

/// Followed from one light. All of them lose nothing by chance where one reflection in 10,000 loses its light: e^-3.
constexpr int kWalks = 32;
constexpr int kReflections = 1000;  // of one walk
constexpr std::size_t kMostLights = 64;

/// Mean of a texture's texels, on a lattice of at most 32 x 32.
Rgb meanOf(const Scene& scene, const TextureSlot& slot) {
    if (!slot.used()) return Rgb(1.0F);
    constexpr int kSide = 32;
    const auto& texture = scene.textures[static_cast<std::size_t>(slot.texture)];
    Rgb sum;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            sum += texture.sample(slot.apply({(static_cast<float>(x) + 0.5F) / kSide, (static_cast<float>(y) + 0.5F) / kSide}));
    return sum / (kSide * kSide);
}

/// Reflected and let through, by a material that is no mixture.
struct GivenBack {
    Rgb reflected, through;
};

GivenBack givenBack(const Scene& scene, const Material& m) {
    const Rgb diffuse = m.reflectance * meanOf(scene, m.reflectanceTexture);
    switch (m.kind) {
        case MaterialKind::Matte: return {diffuse, Rgb{}};
        case MaterialKind::Plastic: return {diffuse * (1 - m.specular.max()) + m.specular, Rgb{}};
        case MaterialKind::Metal:
        case MaterialKind::Mirror: return {m.specular, Rgb{}};
        case MaterialKind::MetallicRoughness: return {diffuse * 0.96F + Rgb(0.04F), Rgb{}};
        case MaterialKind::Ward: return {diffuse + m.specular, m.diffuseTransmittance + m.specularTransmittance};
        case MaterialKind::ThinGlass: {
            const auto light = paneLight(m.transmittance, m.ior, 1);
            return {light.reflected, light.transmitted};
        }
        case MaterialKind::Dielectric: return {Rgb{}, m.transmittance};  // in and out again: absorbed inside alone
        case MaterialKind::Mix: break;
    }
    return {};
}

/// Follows light from surface to surface, always the way that loses least.
class Walker {
public:
    explicit Walker(const TransportScene& scene) : scene_(scene) {
        for (const auto& material : scene.scene.materials) given_.push_back(mostGivenBack(scene.scene, material));
    }

    /// Whether one of the walks from a point is lost, into the sky or to a surface that absorbs.
    bool loses(const Vec3& from) {
        for (int walk = 0; walk < kWalks; ++walk) {
            const Vec2 u = next2D();
            const float z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0F, 1 - z * z)), phi = 2 * kPi * u.y;
            Ray ray{from, 0, {r * std::cos(phi), r * std::sin(phi), z}, kInfinity};
            for (int i = 0; i < kReflections; ++i)
                if (!goOn(ray)) return true;
        }
        return false;
    }

private:
    bool goOn(Ray& ray) {
        Hit hit;
        scene_.raycaster.closestHits({&ray, 1}, {&hit, 1}, Targets::Surfaces);
        if (!hit.surface()) return false;
        const auto material = scene_.scene.meshes[hit.mesh].material;
        if (given_[material] < kGivesAllBack) return false;
        const auto point = surfacePoint(scene_.scene, scene_.needs, ray, hit);
        const auto& m = scene_.scene.materials[material];
        Vec3 direction = Frame::about(point.geometricNormal).toWorld(cosineHemisphere(next2D()));
        const bool through = m.kind == MaterialKind::ThinGlass || m.kind == MaterialKind::Dielectric || m.kind == MaterialKind::Ward;
        if (through && random_.uniform() < 0.5) direction = ray.direction;
        ray = {point.departure(direction), 0, direction, kInfinity};
        return true;
    }
    Vec2 next2D() {
        const auto x = static_cast<float>(random_.uniform()), y = static_cast<float>(random_.uniform());
        return {x, y};
    }

    const TransportScene& scene_;
    std::vector<float> given_;  // by material
    RandomStream random_{1};
};

/// A light to begin at, and what to call it.
struct Beginning {
    Vec3 position;
    std::string name;
};

std::vector<Beginning> beginnings(const Scene& scene) {
    std::vector<Beginning> out;
    for (const auto& l : scene.luminaires)
        if (out.size() < kMostLights) out.push_back({l.position, fmt::format("luminaire \"{}\"", l.name)});
    for (const auto& mesh : scene.meshes) {
        if (!scene.materials[mesh.material].emits() || mesh.triangles.empty() || out.size() >= 2 * kMostLights) continue;
        const auto& t = mesh.triangles.front();
        const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        const Vec3 middle = (a + b + c) / 3, normal = cross(b - a, c - a).normalized();
        out.push_back({middle + normal * (16 * spacingAt(middle)), fmt::format("the emitting surface \"{}\"", mesh.name)});
    }
    return out;
}

}  // namespace

float mostGivenBack(const Scene& scene, const Material& m) {
    if (m.hasHoles()) return 1;  // nothing is lost in a hole
    if (m.kind == MaterialKind::Mix)
        return std::min(mostGivenBack(scene, scene.materials[m.mixFirst]), mostGivenBack(scene, scene.materials[m.mixSecond]));
    if (m.reflectancePattern >= 0) return 0;  // somewhere it absorbs
    const auto given = givenBack(scene, m);
    return (given.reflected + given.through).max();
}

double meanReflectance(const Scene& scene) {
    std::vector<float> reflected;
    for (const auto& m : scene.materials) {
        const auto& own = m.kind == MaterialKind::Mix ? scene.materials[m.mixFirst] : m;
        reflected.push_back(std::min(1.0F, givenBack(scene, own).reflected.max()));
    }
    double area = 0, sum = 0;
    for (const auto& mesh : scene.meshes)
        for (const auto& t : mesh.triangles) {
            const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
            const double own = (b - a).cross(c - a).length() / 2;
            area += own, sum += own * reflected[mesh.material];
        }
    return area > 0 ? sum / area : 0;
}

Result<void> checkThatLightIsLost(const TransportScene& transport) {
    const auto& scene = transport.scene;
    const bool any = std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const auto& mesh) {
        return mostGivenBack(scene, scene.materials[mesh.material]) >= kGivesAllBack;
    });
    if (!any) return {};
    Walker walker(transport);
    for (const auto& light : beginnings(scene))
        if (!walker.loses(light.position))
            return Error{ErrorCode::InvalidArgument,
                         fmt::format("light of {} is never lost: {} reflections met only surfaces that give back everything (reflectance 1 in a "
                                     "closed room), where it grows without bound; expected a reflectance below 1 or an opening",
                                     light.name, kWalks * kReflections), scene.name};
    return {};
}

}  // namespace luxdeck
