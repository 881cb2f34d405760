#include "engine/transport/tracer/light_choice.h"

#include "engine/sampling/sky_sampler.h"

#include <algorithm>

namespace luxdeck {

namespace {

LightSample chooseSky(const SkySampler& sky, const Receiver& at, float share, float uSelect, Vec2 u) {
    const auto chosen = sky.sample(at, uSelect, u);
    LightSample out;
    if (!(chosen.pdfSolidAngle > 0)) return out;
    out.direction = chosen.direction;
    out.distance = kInfinity;
    out.pdfSolidAngle = share * chosen.pdfSolidAngle;
    out.weight = chosen.radiance * (1 / out.pdfSolidAngle);
    out.shared = chosen.shared;
    return out;
}

/// `lamps` chooses among the other lights by the random number it is given.
template <class Lamps>
LightSample choose(const TransportScene& scene, const Receiver& at, float uSelect, Vec2 u, const Lamps& lamps) {
    if (scene.sky == nullptr) return lamps(uSelect);
    const float share = scene.sky->share(at);
    if (uSelect < share) return chooseSky(*scene.sky, at, share, uSelect / share, u);
    auto out = lamps(std::min((uSelect - share) / (1 - share), 0x1.fffffep-1F));
    out.weight *= 1 / (1 - share);
    out.pdfSolidAngle *= 1 - share;
    return out;
}

}  // namespace

LightSample chooseLight(const TransportScene& scene, const Receiver& at, float uSelect, Vec2 u) {
    return choose(scene, at, uSelect, u, [&](float select) { return scene.lights.sample(at, select, u); });
}

LightSample chooseLight(const TransportScene& scene, const Receiver& at, const LightSampler::Weights& weights,
                        float uSelect, Vec2 u) {
    return choose(scene, at, uSelect, u, [&](float select) { return scene.lights.sample(at, weights, select, u); });
}

float lampChance(const TransportScene& scene, const Receiver& at) {
    return scene.sky == nullptr ? 1.0F : 1 - scene.sky->share(at);
}

Rgb skyRadiance(const TransportScene& scene, const Receiver& at, const Vec3& direction, float pdfSolidAngle, Suns suns) {
    const auto& sky = scene.scene.sky;
    const auto weight = [&](float lightPdf) { return pdfSolidAngle / (pdfSolidAngle + lightPdf); };
    const bool weighs = pdfSolidAngle > 0 && scene.sky != nullptr;
    const float share = weighs ? scene.sky->share(at) : 0;
    Rgb radiance = sky.radiance(direction) * (weighs ? weight(share * scene.sky->pdf(at, direction)) : 1.0F);
    for (std::size_t i = 0; i < sky.suns.size() && suns == Suns::With; ++i)
        if (sky.suns[i].covers(direction)) radiance += sky.suns[i].radiance * (weighs ? weight(share * scene.sky->pdfSun(at, i)) : 1.0F);
    return radiance;
}

}  // namespace luxdeck
