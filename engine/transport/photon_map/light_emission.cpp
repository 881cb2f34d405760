#include "engine/transport/photon_map/light_emission.h"

#include "engine/sampling/warp.h"
#include "engine/scene/appearance.h"
#include "engine/scene/opening.h"
#include "engine/transport/surface/surface_point.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

constexpr double kSkyShare = 0.5;
/// Part of a sky's choices that goes to all texels alike: a texel is looked at in its middle alone.
constexpr double kEvenly = 0.1;
constexpr int kMostTries = 256;      // of finding a point of a body that faces a direction
constexpr float kMargin = 1e-3F;     // by which the bounds are wider than the scene [-]

/// Source: engine/scene/candela_table.h, the angles of the three types.
Vec3 directionOf(PhotometryType type, float v, float h) {
    switch (type) {
        case PhotometryType::C: return {std::sin(v) * std::cos(h), std::sin(v) * std::sin(h), -std::cos(v)};
        case PhotometryType::B: return {std::cos(h) * std::sin(v), -std::sin(h), -std::cos(h) * std::cos(v)};
        case PhotometryType::A: return {std::sin(v), -std::cos(v) * std::sin(h), -std::cos(v) * std::cos(h)};
    }
    return {0, 0, -1};
}

float between(float a, float b, float u) { return a + (b - a) * u; }

}  // namespace

LightEmission::LightEmission(const TransportScene& scene) : scene_(scene.scene), needs_(scene.needs), bounds_(scene.scene.bounds()) {
    addLuminaires();
    if (needs_.meshLights) addTriangles();
    double lamps = 0, sky = 0;
    for (const auto& s : sources_) lamps += s.powerLm;
    const std::size_t firstOfSky = sources_.size();
    if (needs_.sky && !bounds_.isEmpty()) addSky();
    for (std::size_t i = firstOfSky; i < sources_.size(); ++i) sky += sources_[i].powerLm;
    std::vector<double> weights;
    for (std::size_t i = 0; i < sources_.size(); ++i) {
        const bool ofSky = i >= firstOfSky;
        const double share = lamps > 0 && sky > 0 ? (ofSky ? kSkyShare : 1 - kSkyShare) : 1;
        weights.push_back(share * sources_[i].powerLm / (ofSky ? sky : lamps));
    }
    if (!weights.empty()) chances_ = AliasTable(weights);
}

void LightEmission::addLuminaires() {
    for (const auto& type : scene_.luminaireTypes) directions_.push_back(directionsOf(type.photometry.table));
    for (std::uint32_t i = 0; i < scene_.luminaires.size(); ++i) {
        const auto& l = scene_.luminaires[i];
        const double lumens = scene_.luminaireTypes[l.type].photometry.table.lumens() * l.outputScale();
        if (lumens > 0 && !directions_[l.type].cells.empty()) sources_.push_back({Kind::Luminaire, i, 0, lumens});
    }
}

LightEmission::Directions LightEmission::directionsOf(const CandelaTable& table) {
    Directions out;
    const auto& vs = table.vertical();
    auto hs = table.horizontal();
    const bool axial = hs.size() == 1;
    if (axial && table.type() != PhotometryType::C) return out;
    if (axial) hs = {0, 360};
    const auto candela = [&](std::size_t h, std::size_t v) { return table.candela()[(axial ? 0 : h) * vs.size() + v]; };
    std::vector<double> weights;
    for (std::size_t h = 0; h + 1 < hs.size(); ++h)
        for (std::size_t v = 0; v + 1 < vs.size(); ++v) {
            const double mean = (candela(h, v) + candela(h + 1, v) + candela(h, v + 1) + candela(h + 1, v + 1)) / 4;
            if (!(mean > 0)) continue;
            const double v0 = vs[v] * kDegree, v1 = vs[v + 1] * kDegree, h0 = hs[h] * kDegree, h1 = hs[h + 1] * kDegree;
            const double solidAngle = table.type() == PhotometryType::C   ? (std::cos(v0) - std::cos(v1)) * (h1 - h0)
                                      : table.type() == PhotometryType::B ? (std::sin(h1) - std::sin(h0)) * (v1 - v0)
                                                                          : (std::sin(v1) - std::sin(v0)) * (h1 - h0);
            out.cells.push_back({static_cast<float>(v0), static_cast<float>(v1), static_cast<float>(h0), static_cast<float>(h1), static_cast<float>(solidAngle)});
            weights.push_back(mean * solidAngle);
        }
    if (!weights.empty()) out.chances = AliasTable(weights);
    return out;
}

void LightEmission::addTriangles() {
    for (std::uint32_t m = 0; m < scene_.meshes.size(); ++m) {
        const auto& mesh = scene_.meshes[m];
        const auto& material = scene_.materials[mesh.material];
        if (!material.emits() || !material.emissionLights) continue;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            const float area = 0.5F * cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).length();
            const double power = kPiD * double{area} * double{meanEmission(scene_, mesh, t)} * (material.oneSidedEmission ? 1 : 2);
            if (power > 0) sources_.push_back({Kind::Triangle, m, t, power});
        }
    }
}

void LightEmission::addSky() {
    std::vector<double> weights(SkyMap::kTexels);
    double sum = 0;
    for (std::uint32_t t = 0; t < SkyMap::kTexels; ++t) {
        const Vec3 towards = SkyMap::centre(t);
        const float luminous = luminance(scene_.sky.radiance(towards), scene_.weights);
        if (std::isfinite(luminous)) weights[t] = double{luminous} * double{SkyMap::kTexelSr} * double{crossSectionM2(towards)};
        sum += weights[t];
    }
    if (sum > 0) {
        for (auto& w : weights) w = (1 - kEvenly) * w + kEvenly * sum / SkyMap::kTexels;
        texels_ = AliasTable(weights);
        sources_.push_back({Kind::Sky, 0, 0, sum});
    }
    for (std::uint32_t i = 0; i < scene_.sky.suns.size(); ++i) {
        const auto& sun = scene_.sky.suns[i];
        const double power = double{luminance(sun.normalIrradiance(), scene_.weights)} * double{crossSectionM2(sun.direction)};
        if (power > 0) sources_.push_back({Kind::Sun, i, 0, power});
    }
}

float LightEmission::crossSectionM2(const Vec3& d) const {
    const Vec3 size = bounds_.size() * (1 + kMargin);
    return size.y * size.z * std::abs(d.x) + size.x * size.z * std::abs(d.y) + size.x * size.y * std::abs(d.z);
}

EmittedPhoton LightEmission::emit(SamplePath& numbers) const {
    const auto draw = chances_.draw(numbers.next1D());
    const auto& source = sources_[draw.index];
    EmittedPhoton photon;
    switch (source.kind) {
        case Kind::Luminaire: photon = fromLuminaire(source, numbers); break;
        case Kind::Triangle: photon = fromTriangle(source, numbers); break;
        case Kind::Sky: photon = fromSky(numbers); break;
        case Kind::Sun: photon = fromSun(source, numbers); break;
    }
    photon.power *= 1 / draw.probability;
    return photon;
}

EmittedPhoton LightEmission::fromLuminaire(const Source& source, SamplePath& numbers) const {
    const auto& luminaire = scene_.luminaires[source.index];
    const auto& type = scene_.luminaireTypes[luminaire.type];
    const auto& table = type.photometry.table;
    const auto& directions = directions_[luminaire.type];
    const auto draw = directions.chances.draw(numbers.next1D());
    const auto& cell = directions.cells[draw.index];
    const Vec2 u = numbers.next2D();
    float v = between(cell.v0, cell.v1, u.x), h = between(cell.h0, cell.h1, u.y);
    // Evenly by solid angle: the angle that is a latitude, or one from the pole, by its sine or cosine.
    if (table.type() == PhotometryType::C) v = std::acos(std::clamp(between(std::cos(cell.v0), std::cos(cell.v1), u.x), -1.0F, 1.0F));
    else if (table.type() == PhotometryType::B) h = std::asin(std::clamp(between(std::sin(cell.h0), std::sin(cell.h1), u.y), -1.0F, 1.0F));
    else v = std::asin(std::clamp(between(std::sin(cell.v0), std::sin(cell.v1), u.x), -1.0F, 1.0F));
    const Vec3 local = directionOf(table.type(), v, h);

    EmittedPhoton photon;
    const float candela = table.intensity(local) * static_cast<float>(luminaire.outputScale());
    photon.power = type.colour * (candela * cell.solidAngle / draw.probability);
    const Vec3 direction = luminaire.frame.toWorld(local).normalized();
    const auto opening = PlacedOpening::of(luminaire, type.photometry.opening);
    auto at = opening.samplePoint(numbers.next2D());
    photon.fromPoint = opening.shape == OpeningShape::Point;
    if (!photon.fromPoint && !opening.flat())  // evenly over what shows in that direction
        for (int i = 0; i < kMostTries && numbers.next1D() >= dot(at.normal, direction); ++i) at = opening.samplePoint(numbers.next2D());
    photon.ray = {at.position, 0, direction, kInfinity};
    return photon;
}

EmittedPhoton LightEmission::fromTriangle(const Source& source, SamplePath& numbers) const {
    const auto& mesh = scene_.meshes[source.index];
    const auto& material = scene_.materials[mesh.material];
    const auto& [a, b, c] = mesh.triangles[source.triangle];
    const Vec3 across = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    const Vec2 u = numbers.next2D();
    const bool back = !material.oneSidedEmission && numbers.next1D() < 0.5F;
    const Vec3 normal = (back ? -across : across).normalized();
    const Vec3 direction = Frame::about(normal).toWorld(cosineHemisphere(numbers.next2D()));
    const float root = std::sqrt(u.x);
    Hit hit;
    hit.distance = 1, hit.mesh = source.index, hit.triangle = source.triangle, hit.u = root * (1 - u.y), hit.v = root * u.y;
    const auto point = surfacePoint(scene_, needs_, {{0, 0, 0}, 0, -direction, kInfinity}, hit);
    EmittedPhoton photon;
    photon.ray = {point.departure(direction), 0, direction, kInfinity};
    const float area = 0.5F * across.length() * (material.oneSidedEmission ? 1.0F : 2.0F) * coverage(scene_, material, point.uv);
    photon.power = emittedRadiance(scene_, material, point.patternPoint(scene_)) * (kPi * area);
    return photon;
}

EmittedPhoton LightEmission::fromSky(SamplePath& numbers) const {
    const auto draw = texels_.draw(numbers.next1D());
    const Vec3 towards = SkyMap::direction(draw.index, numbers.next2D());
    return intoBounds(towards, scene_.sky.radiance(towards) * (SkyMap::kTexelSr / draw.probability), numbers);
}

EmittedPhoton LightEmission::fromSun(const Source& source, SamplePath& numbers) const {
    const auto& sun = scene_.sky.suns[source.index];
    const Vec2 disc = concentricDisc(numbers.next2D());
    const float sine = static_cast<float>(std::sin(sun.halfAngleRad));  // evenly over the disc that a facing surface weighs by
    const float x = sine * disc.x, y = sine * disc.y;
    const Vec3 towards = Frame::about(sun.direction).toWorld({x, y, std::sqrt(std::max(0.0F, 1 - x * x - y * y))});
    return intoBounds(towards, sun.normalIrradiance(), numbers);
}

EmittedPhoton LightEmission::intoBounds(const Vec3& towards, const Rgb& powerPerM2, SamplePath& numbers) const {
    const Vec3 centre = bounds_.center(), size = bounds_.size() * (1 + kMargin);
    const std::array<float, 3> faces{size.y * size.z * std::abs(towards.x), size.x * size.z * std::abs(towards.y), size.x * size.y * std::abs(towards.z)};
    float pick = numbers.next1D() * (faces[0] + faces[1] + faces[2]);
    int axis = 0;
    while (axis < 2 && pick >= faces[static_cast<std::size_t>(axis)]) pick -= faces[static_cast<std::size_t>(axis++)];
    const Vec2 u = numbers.next2D();
    Vec3 at = centre;
    at[axis] += std::copysign(0.5F * size[axis], towards[axis]);
    at[(axis + 1) % 3] += (u.x - 0.5F) * size[(axis + 1) % 3];
    at[(axis + 2) % 3] += (u.y - 0.5F) * size[(axis + 2) % 3];
    EmittedPhoton photon;
    photon.ray = {at, 0, -towards, kInfinity};
    photon.power = powerPerM2 * crossSectionM2(towards);
    return photon;
}

}  // namespace luxdeck
