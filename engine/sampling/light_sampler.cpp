#include "engine/sampling/light_sampler.h"

#include "engine/scene/appearance.h"
#include "engine/sampling/octahedral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace luxdeck {

namespace {

constexpr std::uint32_t kNoLight = 0xffffffffU;

/// This part of all samples goes by flux alone, so that no light's chance is zero where the coarse
/// importance is wrong, and no weight grows beyond ten times its fair size.
constexpr float kDefensive = 0.1F;

Vec3 triangleCross(const Mesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
}

}  // namespace

LightSampler::LightSampler(const Scene& scene, const SceneNeeds& needs)
    : scene_(&scene), manyLights_(needs.manyLights) {
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
    manyLights_ = manyLights_ || lights_.size() + triangles_.size() > kManyLights;
    if (manyLights_) growTree();
    else fillRows();
}

void LightSampler::addLuminaires(const Scene& scene) {
    for (const auto& type : scene.luminaireTypes) addImportanceMap(type.photometry.table);
    lightOfLuminaire_.assign(scene.luminaires.size(), kNoLight);
    for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
        const auto& l = scene.luminaires[i];
        const auto& type = scene.luminaireTypes[l.type];
        const auto& table = type.photometry.table;
        const double lumens = runningLumens(l, type);
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
        if (!material.emits() || !material.emissionLights) continue;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const float area = 0.5F * triangleCross(mesh, t).length();
            triangleIndex_[m].push_back(static_cast<std::uint32_t>(triangles_.size()));
            const auto& [a, b, c] = mesh.triangles[t];
            triangles_.push_back({static_cast<std::uint32_t>(m), t, area,
                                  (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0F,
                                  area * meanEmission(scene, mesh, t)});
            powers.push_back(triangles_.back().fluxCd);
            trianglesFlux_ += static_cast<float>(powers.back());
            for (const auto v : mesh.triangles[t]) box.extendBy(mesh.positions[v]);
        }
    }
    if (triangles_.empty()) return;
    trianglePowers_ = AliasTable(powers);
    trianglesCentre_ = box.center();
    trianglesRadius_ = 0.5F * box.size().length();
}

void LightSampler::addImportanceMap(const CandelaTable& table) {
    constexpr int kSub = 3;  // per texel and side
    const std::size_t first = maps_.size();
    maps_.resize(first + kMapSide * kMapSide, 0.0F);
    for (int y = 0; y < kMapSide * kSub; ++y)
        for (int x = 0; x < kMapSide * kSub; ++x) {
            const float u = (static_cast<float>(x) + 0.5F) / (kMapSide * kSub);
            const float v = (static_cast<float>(y) + 0.5F) / (kMapSide * kSub);
            maps_[first + static_cast<std::size_t>(y / kSub * kMapSide + x / kSub)] +=
                table.intensity(octahedralDirection(u, v)) / (kSub * kSub);
        }
}

void LightSampler::fillRows() {
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const auto& light = lights_[i];
        const auto& [centre, frame] = std::tie(light.opening.centre, light.opening.frame);
        rows_.x[i] = centre.x, rows_.y[i] = centre.y, rows_.z[i] = centre.z;
        rows_.tx[i] = frame.tangent.x, rows_.ty[i] = frame.tangent.y, rows_.tz[i] = frame.tangent.z;
        rows_.bx[i] = frame.bitangent.x, rows_.by[i] = frame.bitangent.y, rows_.bz[i] = frame.bitangent.z;
        rows_.nx[i] = frame.normal.x, rows_.ny[i] = frame.normal.y, rows_.nz[i] = frame.normal.z;
        rows_.radius[i] = light.radius, rows_.scale[i] = light.scale;
        rows_.map[i] = static_cast<int>(light.type) * kMapSide * kMapSide;
    }
}

TreeLight LightSampler::treeLight(const TriangleLight& light, std::uint32_t firstMap) const {
    const auto& mesh = scene_->meshes[light.mesh];
    Box3 box;
    for (const auto v : mesh.triangles[light.triangle]) box.extendBy(mesh.positions[v]);
    TreeLight out;
    out.centre = box.center(), out.half = box.size() * 0.5F;
    out.frame = Frame::about(triangleCross(mesh, light.triangle).normalized());
    out.map = firstMap + (scene_->materials[mesh.material].oneSidedEmission ? 0U : 1U);
    out.scale = light.fluxCd, out.power = trianglesPowerShare_ * light.fluxCd / trianglesFlux_;
    return out;
}

/// The triangles' maps come after the types': a cosine to the front, and to both sides.
void LightSampler::growTree() {
    const auto firstMap = static_cast<std::uint32_t>(maps_.size() / (kMapSide * kMapSide));
    for (const bool bothSides : {false, true})
        for (int y = 0; y < kMapSide && !triangles_.empty(); ++y)
            for (int x = 0; x < kMapSide; ++x) {
                const float z = octahedralDirection((static_cast<float>(x) + 0.5F) / kMapSide, (static_cast<float>(y) + 0.5F) / kMapSide).z;
                maps_.push_back(std::max(bothSides ? std::abs(z) : z, 0.0F));
            }
    std::vector<TreeLight> lights;
    lights.reserve(lights_.size() + triangles_.size());
    for (const auto& light : lights_) {
        const auto box = light.opening.bounds();
        lights.push_back({box.center(), box.size() * 0.5F, light.opening.frame, light.type, light.scale, light.powerShare});
    }
    for (const auto& triangle : triangles_) lights.push_back(treeLight(triangle, firstMap));
    if (!lights.empty()) tree_ = LightTree(lights, std::exchange(maps_, {}));
}

float LightSampler::triangleImportance(const Receiver& at) const {
    if (triangles_.empty()) return 0;
    const float d2 = (at.position - trianglesCentre_).length2();
    return trianglesFlux_ / std::max(d2, trianglesRadius_ * trianglesRadius_);
}

/// A light's importance is the intensity that its map has towards the receiver, times the cosine there (of the
/// opening's highest point), over d^2. Written without branches, so that it is compiled to vector instructions.
/// Entries beyond the triangles' repeat the sum of all.
LightSampler::Sums LightSampler::sumsOfFew(const Receiver& at) const {
    Sums sums;
    constexpr float kHalfSide = 0.5F * kMapSide, kLastTexel = kMapSide - 1;
    const auto& r = rows_;
    const Vec3 p = at.position, n = at.normal;
    const float leastCosine = n.length2() > 0 ? 0.0F : 1.0F;  // no normal: light from all sides counts in full
    std::array<float, kManyLights> factors;
    std::array<int, kManyLights> texels;
    const std::size_t count = (lights_.size() + 7) / 8 * 8;  // whole vectors; kManyLights is a multiple of 8
    for (std::size_t i = 0; i < count; ++i) {
        const float x = p.x - r.x[i], y = p.y - r.y[i], z = p.z - r.z[i];  // from the light to the receiver
        const float radius2 = r.radius[i] * r.radius[i], length2 = x * x + y * y + z * z;
        const float larger2 = length2 > radius2 ? length2 : radius2;
        const float apart = larger2 > 0 ? 1.0F : 0.0F;  // in the very place of a point light nothing comes from it
        const float d2 = larger2 > 1e-20F ? larger2 : 1e-20F;
        const float height = (r.radius[i] - (n.x * x + n.y * y + n.z * z)) / std::sqrt(d2);
        const float below1 = height < 1.0F ? height : 1.0F;
        const float cosine = below1 > leastCosine ? below1 : leastCosine;
        factors[i] = apart * r.scale[i] * cosine / d2;

        const float lx = r.tx[i] * x + r.ty[i] * y + r.tz[i] * z;
        const float ly = r.bx[i] * x + r.by[i] * y + r.bz[i] * z;
        const float lz = r.nx[i] * x + r.ny[i] * y + r.nz[i] * z;
        const float toOctahedron = 1 / (std::abs(lx) + std::abs(ly) + std::abs(lz) + 1e-30F);
        const float ox = lx * toOctahedron, oy = ly * toOctahedron;
        const float fx = std::copysign(1 - std::abs(oy), ox), fy = std::copysign(1 - std::abs(ox), oy);
        const float tx = ((lz < 0 ? fx : ox) + 1) * kHalfSide, ty = ((lz < 0 ? fy : oy) + 1) * kHalfSide;
        const float cx = tx < kLastTexel ? tx : kLastTexel, cy = ty < kLastTexel ? ty : kLastTexel;
        texels[i] = r.map[i] + static_cast<int>(cy > 0 ? cy : 0) * kMapSide + static_cast<int>(cx > 0 ? cx : 0);
    }
    float sum = 0;
    for (std::size_t i = 0; i < lights_.size(); ++i)
        sums[i] = sum += maps_[static_cast<std::size_t>(texels[i])] * factors[i];
    sum += triangleImportance(at);
    std::fill(sums.begin() + static_cast<std::ptrdiff_t>(lights_.size()), sums.end(), sum);
    return sums;
}

LightSampler::Weights LightSampler::weigh(const Receiver& at) const {
    Weights weights;
    if (!manyLights_) weights.few = sumsOfFew(at);
    else if (!tree_.empty() && tree_.size() <= kMostWeighed) weights.many = tree_.weighAll(at);
    return weights;
}

float LightSampler::importanceIn(const Sums& sums, std::uint32_t light) {
    return light == 0 ? sums[0] : sums[light] - sums[light - 1];
}

float LightSampler::mixed(float importance, float sum, float powerShare) const {
    return sum > 0 ? (1 - kDefensive) * importance / sum + kDefensive * powerShare : powerShare;
}

LightSampler::Choice LightSampler::choose(const Receiver& at, const Sums& sums, float& u) const {
    if (empty()) return {kNoLight, 0};
    if (manyLights_) {
        const auto draw = tree_.draw(at, u);
        return {draw.light, draw.probability};
    }
    const float sum = sums.back();
    if (!(sum > 0) || u < kDefensive) {
        const auto draw = powers_.draw(sum > 0 ? u / kDefensive : u);
        u = draw.rest;
        return {draw.index, mixed(importanceIn(sums, draw.index), sum, draw.probability)};
    }
    const float wanted = std::min((u - kDefensive) / (1 - kDefensive), 0x1.fffffep-1F) * sum;
    std::uint32_t light = 0;  // the first whose sum is above what is wanted, counted without branches
    for (const float below : sums) light += below <= wanted ? 1U : 0U;
    light = std::min(light, static_cast<std::uint32_t>(lights_.size()));
    const float importance = importanceIn(sums, light);
    if (!(importance > 0)) return {kNoLight, 0};  // rounding put what is wanted beyond the last light
    u = std::clamp((wanted - (sums[light] - importance)) / importance, 0.0F, 0x1.fffffep-1F);
    return {light, mixed(importance, sum, powerShare(light))};
}

float LightSampler::probability(const Receiver& at, std::uint32_t light) const {
    if (manyLights_) return tree_.probability(at, light);
    const Sums sums = sumsOfFew(at);
    return mixed(importanceIn(sums, light), sums.back(), powerShare(light));
}

LightSampler::Weights LightSampler::weighThrough(const Receiver& at, const MirrorFrame& window) const {
    if (manyLights_) return {};
    constexpr float kHidden = 0.02F;  // the test looks at centres and rims alone, and may err
    Weights weights = weigh(at);
    auto& sums = weights.few;
    const Vec3 normal = cross(window.u, window.v);
    const float height = dot(normal, window.centre - at.position);
    float before = 0, sum = 0;
    for (std::size_t i = 0; i <= lights_.size(); ++i) {
        float importance = sums[i] - before;
        before = sums[i];
        if (i < lights_.size()) {
            const Vec3 towards = lights_[i].opening.centre - at.position;
            const float s = height / dot(normal, towards);
            const Vec3 off = at.position + towards * s - window.centre;
            const float rim = lights_[i].radius * std::abs(s);
            const bool shows = s > 0 && s < 1 && std::abs(dot(off, window.u)) <= window.halfU + rim &&
                               std::abs(dot(off, window.v)) <= window.halfV + rim;
            if (!shows) importance *= kHidden;
        }
        sums[i] = sum += importance;
    }
    std::fill(sums.begin() + static_cast<std::ptrdiff_t>(lights_.size()), sums.end(), sum);
    return weights;
}

LightSample LightSampler::sample(const Receiver& at, float uSelect, Vec2 u) const {
    const auto choice = choose(at, manyLights_ ? Sums{} : sumsOfFew(at), uSelect);
    return choosePoint(at, choice, uSelect, u);
}

LightSample LightSampler::sample(const Receiver& at, const Weights& weights, float uSelect, Vec2 u) const {
    if (weights.many.empty()) {
        const auto choice = choose(at, weights.few, uSelect);
        return choosePoint(at, choice, uSelect, u);
    }
    const auto draw = tree_.draw(weights.many, uSelect);
    if (!(draw.probability > 0)) return {};  // two sums that rounding made equal
    auto sample = choosePoint(at, {draw.light, draw.probability}, uSelect, u);
    // Directions that meet this light know the tree's chances alone. Weights of two strategies may be made of any
    // density that both agree upon.
    if (sample.shared) sample.pdfSolidAngle *= tree_.probability(at, draw.light) / draw.probability;
    return sample;
}

LightSample LightSampler::choosePoint(const Receiver& at, const Choice& choice, float uSelect, Vec2 u) const {
    if (choice.light == kNoLight) return {};
    LightSample sample;
    if (choice.light < lights_.size()) {
        sample = sampleLuminaire(lights_[choice.light], at, u);
    } else if (manyLights_) {
        sample = sampleTriangle(at, {choice.light - static_cast<std::uint32_t>(lights_.size()), 1, u.x}, u);
    } else {
        sample = sampleTriangle(at, trianglePowers_.draw(uSelect), u);
    }
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
    out.source = light.luminaire;
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

LightSample LightSampler::sampleTriangle(const Receiver& at, const AliasTable::Draw& draw, Vec2 u) const {
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
    out.source = kFromSurfaces;
    out.distance = std::sqrt(d2);
    out.direction = towards / out.distance;
    const float cosine = -dot(triangleCross(mesh, light.triangle), out.direction) / (2 * light.areaM2);
    const float emitting = material.oneSidedEmission ? cosine : std::abs(cosine);
    if (!(emitting > 0)) return {};
    out.shared = shared(at, light);
    out.pdfSolidAngle = draw.probability * d2 / (emitting * light.areaM2);
    const Vec2 uv = mesh.uvs.empty() ? Vec2(0, 0) : mesh.uvs[a] * (1 - root) + mesh.uvs[b] * wb + mesh.uvs[c] * wc;
    out.weight = triangleRadiance(light, position, uv, out) * (1 / out.pdfSolidAngle);
    return out;
}

/// What a point of a triangle emits towards the receiver, holes counted by the part that they leave.
Rgb LightSampler::triangleRadiance(const TriangleLight& light, const Vec3& position, const Vec2& uv,
                                   const LightSample& towards) const {
    const auto& mesh = scene_->meshes[light.mesh];
    const auto& material = scene_->materials[mesh.material];
    if (!material.emissionTexture.used() && material.emissionPattern < 0 && !material.hasHoles()) return material.emission;
    Vec3 normal = triangleCross(mesh, light.triangle).normalized();
    if (dot(normal, towards.direction) > 0) normal = -normal;
    const PatternPoint at{scene_->toUser(position), normal, towards.direction, double{towards.distance}, uv};
    return emittedRadiance(*scene_, material, at) * coverage(*scene_, material, uv);
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
    if (triangleIndex_[mesh].empty()) return 0;  // of a mixture: only directions find what its parts emit
    const auto index = triangleIndex_[mesh][triangle];
    if (!shared(at, triangles_[index])) return std::numeric_limits<float>::infinity();
    const auto lights = static_cast<std::uint32_t>(lights_.size());
    const float chance = manyLights_ ? probability(at, lights + index) : probability(at, lights) * trianglePowers_.probability(index);
    return chance * distance * distance / (cosine * triangles_[index].areaM2);
}

}  // namespace luxdeck
