#include "engine/sampling/light_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace luxdeck {

namespace {

constexpr std::uint32_t kNoLight = 0xffffffffU;

/// This part of all samples goes by flux alone, so that no light's chance is zero where the coarse
/// importance is wrong, and no weight grows beyond ten times its fair size.
constexpr float kDefensive = 0.1F;

Vec3 octahedralDirection(float u, float v) {
    const float x = 2 * u - 1, y = 2 * v - 1;
    Vec3 d{x, y, 1 - std::abs(x) - std::abs(y)};
    if (d.z < 0) {
        d.x = std::copysign(1 - std::abs(y), x);
        d.y = std::copysign(1 - std::abs(x), y);
    }
    return d.normalized();
}

Vec3 triangleCross(const Mesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
}

}  // namespace

LightSampler::LightSampler(const Scene& scene, const SceneNeeds& needs)
    : scene_(&scene), manyLights_(needs.manyLights || scene.luminaires.size() > kManyLights) {
    addLuminaires(scene);
    if (needs.meshLights) addTriangles(scene);
    std::vector<double> powers;
    for (const auto& light : lights_) powers.push_back(light.powerShare);
    powers.push_back(kPiD * trianglesFlux_);
    double sum = 0;
    for (const double p : powers) sum += p;
    for (std::size_t i = 0; i < lights_.size(); ++i) lights_[i].powerShare = static_cast<float>(powers[i] / sum);
    trianglesPowerShare_ = sum > 0 ? static_cast<float>(powers.back() / sum) : 0;
    powers_ = AliasTable(powers);
}

void LightSampler::addLuminaires(const Scene& scene) {
    for (const auto& type : scene.luminaireTypes) maps_.push_back(importanceMap(type.photometry.table));
    lightOfLuminaire_.assign(scene.luminaires.size(), kNoLight);
    for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
        const auto& l = scene.luminaires[i];
        const auto& type = scene.luminaireTypes[l.type];
        const auto& table = type.photometry.table;
        const double lumens = table.lumens() * l.outputScale();
        if (!(lumens > 0)) continue;
        const auto opening = PlacedOpening::of(l, type.photometry.opening);
        lightOfLuminaire_[i] = static_cast<std::uint32_t>(lights_.size());
        lights_.push_back({opening, &table, static_cast<std::uint32_t>(i), l.type, opening.halfM.length(),
                           static_cast<float>(l.outputScale()), static_cast<float>(lumens), type.colour});
    }
}

void LightSampler::addTriangles(const Scene& scene) {
    std::vector<double> powers;
    Box3 box;
    triangleIndex_.resize(scene.meshes.size());
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const auto& mesh = scene.meshes[m];
        const auto& material = scene.materials[mesh.material];
        if (!material.emits()) continue;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const float area = 0.5F * triangleCross(mesh, t).length();
            triangleIndex_[m].push_back(static_cast<std::uint32_t>(triangles_.size()));
            const auto& [a, b, c] = mesh.triangles[t];
            triangles_.push_back({static_cast<std::uint32_t>(m), t, area,
                                  (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0F});
            powers.push_back(double{area} * luminance(material.emission, scene.weights));
            trianglesFlux_ += static_cast<float>(powers.back());
            for (const auto v : mesh.triangles[t]) box.extendBy(mesh.positions[v]);
        }
    }
    if (triangles_.empty()) return;
    trianglePowers_ = AliasTable(powers);
    trianglesCentre_ = box.center();
    trianglesRadius_ = 0.5F * box.size().length();
}

LightSampler::ImportanceMap LightSampler::importanceMap(const CandelaTable& table) const {
    constexpr int kSub = 3;  // per texel and side
    ImportanceMap map;
    map.intensity.assign(kMapSide * kMapSide, 0.0F);
    for (int y = 0; y < kMapSide * kSub; ++y)
        for (int x = 0; x < kMapSide * kSub; ++x) {
            const float u = (static_cast<float>(x) + 0.5F) / (kMapSide * kSub);
            const float v = (static_cast<float>(y) + 0.5F) / (kMapSide * kSub);
            map.intensity[static_cast<std::size_t>(y / kSub * kMapSide + x / kSub)] +=
                table.intensity(octahedralDirection(u, v)) / (kSub * kSub);
        }
    return map;
}

float LightSampler::ImportanceMap::at(const Vec3& d) const {
    const float scale = 1 / (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
    float x = d.x * scale, y = d.y * scale;
    if (d.z < 0) {
        const float foldedX = std::copysign(1 - std::abs(y), x);
        y = std::copysign(1 - std::abs(x), y);
        x = foldedX;
    }
    const auto texel = [](float w) {
        return std::clamp(static_cast<int>((w + 1) * (0.5F * kMapSide)), 0, kMapSide - 1);
    };
    return intensity[static_cast<std::size_t>(texel(y) * kMapSide + texel(x))];
}

float LightSampler::importance(const Light& light, const Receiver& at) const {
    const Vec3 away = at.position - light.opening.centre;  // from the light to the receiver
    const float d2 = std::max(away.length2(), light.radius * light.radius);
    if (!(d2 > 0)) return 0;
    const float d = std::sqrt(d2);
    float cosine = 1;
    if (at.normal.length2() > 0) cosine = std::clamp((light.radius - dot(at.normal, away)) / d, 0.0F, 1.0F);
    if (cosine == 0) return 0;
    return maps_[light.importanceMap].at(light.opening.frame.toLocal(away)) * light.scale * cosine / d2;
}

float LightSampler::triangleImportance(const Receiver& at) const {
    if (triangles_.empty()) return 0;
    const float d2 = (at.position - trianglesCentre_).length2();
    return trianglesFlux_ / std::max(d2, trianglesRadius_ * trianglesRadius_);
}

float LightSampler::weigh(const Receiver& at, float* importances) const {
    float sum = 0;
    for (std::size_t i = 0; i < lights_.size(); ++i) sum += importances[i] = importance(lights_[i], at);
    sum += importances[lights_.size()] = triangleImportance(at);
    return sum;
}

float LightSampler::mixed(float importance, float sum, float powerShare) const {
    return sum > 0 ? (1 - kDefensive) * importance / sum + kDefensive * powerShare : powerShare;
}

LightSampler::Choice LightSampler::choose(const Receiver& at, float& u) const {
    if (manyLights_) {
        const auto draw = powers_.draw(u);
        u = draw.rest;
        return {draw.index, draw.probability};
    }
    std::array<float, kManyLights + 1> importances;
    const float sum = weigh(at, importances.data());
    float below = 0;
    Choice choice{kNoLight, 0};
    for (std::uint32_t i = 0; i <= lights_.size(); ++i) {
        const float share = i < lights_.size() ? lights_[i].powerShare : trianglesPowerShare_;
        const float p = mixed(importances[i], sum, share);
        if (!(p > 0)) continue;
        choice = {i, p};  // rounding may leave u above the last sum: the last possible light takes it
        if (u < below + p) break;
        below += p;
    }
    u = choice.probability > 0 ? std::clamp((u - below) / choice.probability, 0.0F, 0x1.fffffep-1F) : 0;
    return choice;
}

float LightSampler::probability(const Receiver& at, std::uint32_t light) const {
    if (manyLights_) return powers_.probability(light);
    std::array<float, kManyLights + 1> importances;
    const float sum = weigh(at, importances.data());
    return mixed(importances[light], sum, light < lights_.size() ? lights_[light].powerShare : trianglesPowerShare_);
}

LightSample LightSampler::sample(const Receiver& at, float uSelect, Vec2 u) const {
    if (empty()) return {};
    const auto choice = choose(at, uSelect);
    if (choice.light == kNoLight) return {};
    auto sample = choice.light < lights_.size() ? sampleLuminaire(lights_[choice.light], at, u)
                                                : sampleTriangle(at, {uSelect, u.x});
    sample.weight *= 1 / choice.probability;
    sample.pdfSolidAngle *= choice.probability;
    return sample;
}

bool LightSampler::shared(const Receiver& at, const Light& light) {
    return at.glossy || (at.position - light.opening.centre).length2() < 4 * light.radius * light.radius;
}

bool LightSampler::shared(const Receiver& at, const TriangleLight& light) {
    return at.glossy || (at.position - light.centroid).length2() < 16 * light.areaM2;
}

LightSample LightSampler::sampleLuminaire(const Light& light, const Receiver& at, Vec2 u) const {
    const auto point = light.opening.samplePoint(u);
    const Vec3 towards = point.position - at.position;
    const float d2 = towards.length2();
    if (!(d2 > 0)) return {};
    LightSample out;
    out.distance = std::sqrt(d2);
    out.direction = towards / out.distance;
    const Vec3 local = light.opening.frame.toLocal(-out.direction);
    const Rgb intensity = light.colour * (light.table->intensity(local) * light.scale);
    if (light.opening.shape == OpeningShape::Point) {
        out.weight = intensity * (1 / d2);
        return out;
    }
    const float cosine = -dot(point.normal, out.direction);
    const float emitting = point.twoSided ? std::abs(cosine) : cosine;
    if (!(emitting > 0)) return {};
    const float area = light.opening.areaM2();
    out.shared = shared(at, light);
    out.pdfSolidAngle = d2 / (emitting * area);
    out.weight = intensity * (1 / (light.opening.projectedAreaM2(local) * out.pdfSolidAngle));
    return out;
}

LightSample LightSampler::sampleTriangle(const Receiver& at, Vec2 u) const {
    const auto draw = trianglePowers_.draw(u.x);
    const auto& light = triangles_[draw.index];
    const auto& mesh = scene_->meshes[light.mesh];
    const auto& material = scene_->materials[mesh.material];
    const auto& [a, b, c] = mesh.triangles[light.triangle];
    const float root = std::sqrt(draw.rest), wb = root * (1 - u.y), wc = root * u.y;
    const Vec3 position = mesh.positions[a] * (1 - root) + mesh.positions[b] * wb + mesh.positions[c] * wc;
    const Vec3 towards = position - at.position;
    const float d2 = towards.length2();
    if (!(d2 > 0)) return {};
    LightSample out;
    out.distance = std::sqrt(d2);
    out.direction = towards / out.distance;
    const float cosine = -dot(triangleCross(mesh, light.triangle), out.direction) / (2 * light.areaM2);
    const float emitting = material.oneSidedEmission ? cosine : std::abs(cosine);
    if (!(emitting > 0)) return {};
    out.shared = shared(at, light);
    out.pdfSolidAngle = draw.probability * d2 / (emitting * light.areaM2);
    Rgb radiance = material.emission;
    if (material.emissionTexture.used() && !mesh.uvs.empty()) {
        const Vec2 uv = mesh.uvs[a] * (1 - root) + mesh.uvs[b] * wb + mesh.uvs[c] * wc;
        radiance *= scene_->textures[static_cast<std::size_t>(material.emissionTexture.texture)].sample(
            material.emissionTexture.apply(uv));
    }
    out.weight = radiance * (1 / out.pdfSolidAngle);
    return out;
}

Rgb LightSampler::openingRadiance(std::uint32_t luminaire, const Vec3& leaving) const {
    const auto& light = lights_[lightOfLuminaire_[luminaire]];
    const Vec3 local = light.opening.frame.toLocal(leaving);
    return light.colour * (light.table->intensity(local) * light.scale / light.opening.projectedAreaM2(local));
}

float LightSampler::pdfOpening(const Receiver& at, std::uint32_t luminaire, const Vec3& direction) const {
    const auto index = lightOfLuminaire_[luminaire];
    const auto& light = lights_[index];
    if (!shared(at, light)) return std::numeric_limits<float>::infinity();
    // A ray through a closed body meets its surface twice; only the near side emits towards the receiver.
    const auto met = light.opening.intersect(at.position, direction, 0, std::numeric_limits<float>::infinity());
    if (!met) return 0;
    const float cosine = -dot(met->normal, direction);
    const float emitting = light.opening.flat() ? std::abs(cosine) : cosine;
    if (!(emitting > 0)) return 0;
    return probability(at, index) * met->distance * met->distance / (emitting * light.opening.areaM2());
}

float LightSampler::pdfTriangle(const Receiver& at, std::uint32_t mesh, std::uint32_t triangle, float distance,
                                float cosine) const {
    if (triangles_.empty() || !(cosine > 0)) return 0;
    const auto index = triangleIndex_[mesh][triangle];
    if (!shared(at, triangles_[index])) return std::numeric_limits<float>::infinity();
    return probability(at, static_cast<std::uint32_t>(lights_.size())) * trianglePowers_.probability(index) * distance *
           distance / (cosine * triangles_[index].areaM2);
}

}  // namespace luxdeck
