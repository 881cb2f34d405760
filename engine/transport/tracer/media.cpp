#include "engine/transport/tracer/media.h"

#include "engine/transport/surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace luxdeck {

namespace {

/// Not along any likely wall or edge.
const Vec3 kProbeDirection = Vec3(0.3141F, 0.2718F, 0.9092F).normalized();
constexpr int kMostSurfaces = 100'000;

}  // namespace

std::size_t Media::find(const Material& material) const {
    std::size_t place = depth_;
    while (place > 0 && solids_[place - 1] != &material) --place;
    return place;
}

float Media::iorAround(const Material& material) const {
    const std::size_t place = find(material);
    if (place == 0 || place < depth_) return ior();  // another solid begun inside it goes on outside
    return place >= 2 ? solids_[place - 2]->ior : 1.0F;
}

Rgb Media::transmittance(float lengthM) const {
    if (inAir()) return Rgb(1.0F);
    const Rgb& t = solids_[depth_ - 1]->transmittance;  // of a metre
    return {std::pow(t.r, lengthM), std::pow(t.g, lengthM), std::pow(t.b, lengthM)};
}

bool Media::enter(const Material& material) {
    if (depth_ == kDeepest) return false;
    solids_[depth_++] = &material;
    return true;
}

void Media::leave(const Material& material) {
    const std::size_t place = find(material);
    if (place == 0) return;
    std::move(solids_.begin() + static_cast<std::ptrdiff_t>(place), solids_.begin() + static_cast<std::ptrdiff_t>(depth_),
              solids_.begin() + static_cast<std::ptrdiff_t>(place - 1));
    --depth_;
}

Media mediaAt(const TransportScene& scene, const Vec3& position, TransportCounters& counters) {
    std::vector<const Material*> entered, around;  // around: innermost first
    Ray ray{position, 0, kProbeDirection, kInfinity};
    for (int i = 0; i < kMostSurfaces && isGood(ray); ++i) {
        Hit hit;
        scene.raycaster.closestHits({&ray, 1}, {&hit, 1}, Targets::Opaque);
        ++counters.rays;
        if (!hit.surface()) break;
        const auto point = surfacePoint(scene.scene, scene.needs, ray, hit);
        ray.tMin = hit.distance * (1 + 4e-7F) + 8 * point.ulp;
        if (point.material->kind != MaterialKind::Dielectric) continue;
        const auto open = std::find(entered.rbegin(), entered.rend(), point.material);
        if (point.frontFace) entered.push_back(point.material);
        else if (open != entered.rend()) entered.erase(std::next(open).base());
        else around.push_back(point.material);
    }
    Media media;
    const std::size_t kept = std::min(around.size(), Media::kDeepest);
    for (std::size_t i = kept; i > 0; --i) (void)media.enter(*around[i - 1]);
    return media;
}

const Media& MediaFinder::at(const Vec3& position, TransportCounters& counters) {
    if (known_ && position == position_) return media_;
    media_ = mediaAt(scene_, position, counters);
    position_ = position, known_ = true;
    return media_;
}

}  // namespace luxdeck
