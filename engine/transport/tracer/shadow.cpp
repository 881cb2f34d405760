#include "engine/transport/tracer/shadow.h"

#include "engine/transport/surface/bsdf.h"
#include "engine/transport/surface/straight.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

/// Calls visit(point) for every pane that a ray passes, near to far, until it returns false.
template <class Visit>
void forEachPane(const TransportScene& scene, Ray ray, TransportCounters& counters, Visit&& visit) {
    std::uint32_t lastMesh = kNothing;
    float lastDistance = 0;
    float step = 0;  // grows while the ray stays in one pane that it grazes, where the kernel's distance is
                     // uncertain: it must get past
    while (true) {
        Hit hit;
        scene.raycaster.closestHits({&ray, 1}, {&hit, 1}, Targets::Panes);
        ++counters.rays;
        if (!hit.surface()) return;
        const auto point = surfacePoint(scene.scene, scene.needs, ray, hit);
        const float spacing = 8 * (point.ulp + hit.distance * 0x1.0p-23F);
        const bool samePane = hit.mesh == lastMesh && hit.distance - lastDistance <= std::max(spacing, step);
        step = samePane ? 2 * step : spacing;
        if (!samePane && !visit(point)) return;
        lastMesh = hit.mesh, lastDistance = hit.distance;
        ray.tMin = std::max(ray.tMin, hit.distance) + step;
        if (!(ray.tMin < ray.tMax)) return;
    }
}

}  // namespace

Rgb paneTransmittance(const TransportScene& scene, Ray ray, TransportCounters& counters) {
    Rgb transmittance(1.0F);
    forEachPane(scene, ray, counters, [&](const SurfacePoint& point) {
        transmittance *= straightTransmittance(scene.scene, point);
        return !transmittance.isBlack();
    });
    return transmittance;
}

Passage passageThroughPanes(const TransportScene& scene, const Ray& ray, TransportCounters& counters) {
    Passage passage;
    forEachPane(scene, ray, counters, [&](const SurfacePoint& point) {
        const Bsdf<Rgb> pane(scene.scene, scene.needs, point);
        if (point.material->kind != MaterialKind::ThinGlass || point.material->hasHoles()) passage = {Rgb{}, 0};
        else passage.transmittance *= straightTransmittance(scene.scene, point), passage.chance *= pane.chanceThrough(std::abs(dot(ray.direction, point.geometricNormal)));
        return passage.chance > 0;
    });
    return passage;
}

}  // namespace luxdeck
