#include "engine/transport/irradiance_cache/reflected_light.h"

#include <algorithm>
#include <utility>

namespace luxdeck {

void ReflectedLight::stand(const FieldPoint& point) {
    point_ = point;
    at_ = {point.position, point.normal};
    const bool byMirrors = seeksByMirrors(scene_) && settings_.maxReflections > 0;
    mirrors_ = byMirrors ? std::make_unique<MirrorTable>(scene_, at_) : nullptr;
}

void ReflectedLight::ask(const Vec3& direction, SamplePath numbers) {
    const std::size_t asked = answers_.size();
    answers_.emplace_back();
    if (mirrors_) {
        float u = numbers.next1D();
        const auto choice = mirrors_->choose(u);
        const auto path = aimByMirror(scene_, at_, choice.mirror, *choice.weights, u, numbers.next2D());
        const float cosine = path ? dot(path->direction, point_.normal) : 0;
        if (cosine > 0 && dot(path->direction, point_.geometricNormal) > 0)
            mirrored_.push_back({*path, path->light.weight * (cosine / choice.probability), point_.position, asked});
    }
    const float cosine = dot(direction, point_.normal);
    if (!(cosine > 0) || dot(direction, point_.geometricNormal) <= 0) return;  // an interpolated normal leans over the surface
    RadianceQuery query;
    query.ray = {point_.position, 0, direction, kInfinity};
    query.numbers = numbers;
    query.pdfSolidAngle = std::max(cosine / kPi, 1e-12F);
    query.origin = at_;
    queries_.push_back(query);
    asked_.push_back(asked);
}

std::vector<ReflectedLight::Answer> ReflectedLight::trace() {
    std::vector<RadianceSample> samples(queries_.size());
    counters_ += tracePaths(scene_, settings_, queries_, samples);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        auto& answer = answers_[asked_[i]];
        answer.radiance = samples[i].direct + samples[i].indirect;
        answer.distance = samples[i].virtualDistance;
        answer.lost = samples[i].lost;
    }
    for (const auto& m : mirrored_) {
        auto& answer = answers_[m.asked];
        answer.mirroredFrom = m.path.direction;
        const Rgb mirrored = m.lux * throughputByMirror(scene_, m.origin, m.path, counters_);
        if (isFinite(mirrored)) answer.mirrored = mirrored;
        else answer.lost += isFinite(m.lux) ? m.lux / kPi : Rgb(kInfinity);  // a mirror passes on all of it at most
    }
    return std::move(answers_);
}

}  // namespace luxdeck
