#include "engine/sampling/sky_sampler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace luxdeck {

namespace {

constexpr int kSub = 4;                 // samples of a texel's luminance, a side
constexpr float kDefensive = 0.1F;      // of the sky's choices by luminance alone
constexpr float kLeastChoice = 0.05F;   // of either, where there are both sky and sun
constexpr float kLeastShare = 0.1F;    // of either, where there are both sky and lamps
constexpr float kLeastCosine = 0.02F;   // of the sun, for shading normals and light that is scattered through

float meanLuminance(const Scene& scene, std::uint32_t texel) {
    float sum = 0;
    for (int i = 0; i < kSub * kSub; ++i) {
        const Vec2 u{(static_cast<float>(i % kSub) + 0.5F) / kSub, (static_cast<float>(i / kSub) + 0.5F) / kSub};
        const float y = luminance(scene.sky.radiance(SkyMap::direction(texel, u)), scene.weights);
        if (std::isfinite(y) && y > 0) sum += y;
    }
    return sum / (kSub * kSub);
}

/// The light of all lamps over the plan of the scene.
float lampLuxOf(const Scene& scene) {
    double lumens = 0;
    for (const auto& l : scene.luminaires) lumens += scene.luminaireTypes[l.type].photometry.table.lumens() * l.outputScale();
    for (const auto& mesh : scene.meshes)
        for (std::uint32_t t = 0; scene.materials[mesh.material].emits() && t < mesh.triangles.size(); ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            const Vec3 twice = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
            lumens += kPiD * luminance(scene.materials[mesh.material].emission, scene.weights) * twice.length() / 2;
        }
    const Vec3 size = scene.bounds().size();
    return lumens > 0 ? static_cast<float>(lumens / std::max(static_cast<double>(size.x) * size.y, 1e-6)) : 0;
}

}  // namespace

SkySampler::SkySampler(const Scene& scene) : scene_(&scene), lampLux_(lampLuxOf(scene)), luminances_(SkyMap::kTexels) {
    for (std::uint32_t t = 0; t < SkyMap::kTexels; ++t) luminances_[t] = scene.sky.present() ? meanLuminance(scene, t) : 0;
    for (std::uint32_t f = 0; f < kFacings; ++f) {
        const Vec3 axis = axisOf(Facing{f});
        std::vector<float> weights(SkyMap::kTexels);
        for (std::uint32_t t = 0; t < SkyMap::kTexels; ++t) {
            const float cosine = Facing{f} == Facing::Any ? 0.5F : std::max(0.0F, dot(SkyMap::centre(t), axis) + 0.05F);
            weights[t] = luminances_[t] * cosine;
            plainLux_[f] += weights[t] * SkyMap::kTexelSr;
        }
        plain_[f] = SkyTable(weights);
    }
    for (const auto& sun : scene.sky.suns) suns_.push_back(luminance(sun.normalIrradiance(), scene.weights));
}

void SkySampler::findVisible(std::unique_ptr<const SkyVisibility> visibility) {
    auto cells = std::make_unique<SkyCells>(*scene_, luminances_, std::move(visibility));
    if (cells->useful()) cells_ = std::move(cells);
}

float SkySampler::sunLux(const Receiver& at, const SkyView* view, std::size_t sun) const {
    const float cosine = at.normal.length2() > 0 ? dot(at.normal, scene_->sky.suns[sun].direction) : 1.0F;
    const bool known = view != nullptr && sun < view->sunShare.size();
    return suns_[sun] * std::max(cosine, kLeastCosine) * (known ? view->sunShare[sun] : 1.0F);
}

SkySampler::Place SkySampler::placeOf(const Receiver& at) const {
    Place place;
    const auto facing = static_cast<std::size_t>(facingOf(at.normal));
    place.view = cells_ ? cells_->view(at) : nullptr;
    place.plain = &plain_[facing];
    place.skyLux = place.view != nullptr ? place.view->lux : plainLux_[facing];
    for (std::size_t s = 0; s < suns_.size(); ++s) place.sunLux += sunLux(at, place.view, s);
    place.viewProbability = place.view == nullptr || place.view->table.black() ? 0 : place.plain->black() ? 1 : 1 - kDefensive;
    if (suns_.empty()) return place;
    const bool skyBlack = place.plain->black() && place.viewProbability == 0;
    const float sum = place.sunLux + place.skyLux;
    place.sunProbability = skyBlack ? 1.0F : std::clamp(sum > 0 ? place.sunLux / sum : 0.5F, kLeastChoice, 1 - kLeastChoice);
    return place;
}

float SkySampler::sunChance(const Receiver& at, const Place& place, std::size_t sun) const {
    const auto count = static_cast<float>(suns_.size());
    const float fair = place.sunLux > 0 ? sunLux(at, place.view, sun) / place.sunLux : 1 / count;
    return place.sunProbability * ((1 - kDefensive) * fair + kDefensive / count);
}

float SkySampler::texelPdf(const Place& place, std::uint32_t texel) const {
    const float byView = place.viewProbability > 0 ? place.viewProbability * place.view->table.probability(texel) : 0;
    const float byLuminance = (1 - place.viewProbability) * place.plain->probability(texel);
    return (1 - place.sunProbability) * (byView + byLuminance) / SkyMap::kTexelSr;
}

SkySample SkySampler::sampleSun(const Receiver& at, const Place& place, float uSelect, Vec2 u) const {
    std::size_t sun = 0;
    float chance = sunChance(at, place, 0), sum = chance;
    while (sun + 1 < suns_.size() && uSelect * place.sunProbability >= sum) sum += chance = sunChance(at, place, ++sun);
    const auto& disc = scene_->sky.suns[sun];
    const double s = std::sin(disc.halfAngleRad / 2), below = 2 * s * s * u.x;  // 1 - cos, without cancellation
    const double sine = std::sqrt(below * (2 - below)), azimuth = 2 * kPiD * u.y;
    const auto frame = Frame::about(disc.direction);
    const Vec3 local(Vec3d(sine * std::cos(azimuth), sine * std::sin(azimuth), 1 - below));
    return {frame.toWorld(local), disc.radiance, chance / static_cast<float>(disc.solidAngle()), at.glossy};
}

SkySample SkySampler::sample(const Receiver& at, float uSelect, Vec2 u) const {
    const auto place = placeOf(at);
    if (uSelect < place.sunProbability) return sampleSun(at, place, uSelect / place.sunProbability, u);
    float select = (uSelect - place.sunProbability) / (1 - place.sunProbability);
    const bool byView = select < place.viewProbability;
    if (!byView && place.plain->black()) return {};
    select = byView ? select / place.viewProbability : (select - place.viewProbability) / (1 - place.viewProbability);
    const auto draw = (byView ? place.view->table : *place.plain).draw(std::clamp(select, 0.0F, 0x1.fffffep-1F));
    const Vec3 direction = SkyMap::direction(draw.texel, u);
    return {direction, scene_->sky.radiance(direction), texelPdf(place, draw.texel), true};
}

float SkySampler::pdf(const Receiver& at, const Vec3& direction) const { return texelPdf(placeOf(at), SkyMap::texelOf(direction)); }

float SkySampler::pdfSun(const Receiver& at, std::size_t sun) const {
    if (!at.glossy) return std::numeric_limits<float>::infinity();
    return sunChance(at, placeOf(at), sun) / static_cast<float>(scene_->sky.suns[sun].solidAngle());
}

float SkySampler::share(const Receiver& at) const {
    if (!(lampLux_ > 0)) return 1;
    const auto place = placeOf(at);
    const float lux = place.skyLux + place.sunLux;
    return std::clamp(lux / (lux + lampLux_), kLeastShare, 1 - kLeastShare);
}

}  // namespace luxdeck
