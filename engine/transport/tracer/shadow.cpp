#include "engine/transport/tracer/shadow.h"

#include "engine/transport/surface/straight.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

Rgb paneTransmittance(const TransportScene& scene, Ray ray, TransportCounters& counters) {
    Rgb transmittance(1.0F);
    std::uint32_t lastMesh = kNothing;
    float lastDistance = 0;
    float step = 0;  // grows while the ray stays in one pane that it grazes, where the kernel's distance is
                     // uncertain: it must get past
    while (!transmittance.isBlack()) {
        Hit hit;
        scene.raycaster.closestHits({&ray, 1}, {&hit, 1}, Targets::Panes);
        ++counters.rays;
        if (!hit.surface()) break;
        const auto point = surfacePoint(scene.scene, scene.needs, ray, hit);
        const float spacing = 8 * (point.ulp + hit.distance * 0x1.0p-23F);
        const bool samePane = hit.mesh == lastMesh && hit.distance - lastDistance <= std::max(spacing, step);
        step = samePane ? 2 * step : spacing;
        if (!samePane) transmittance *= straightTransmittance(scene.scene, point);
        lastMesh = hit.mesh, lastDistance = hit.distance;
        ray.tMin = std::max(ray.tMin, hit.distance) + step;
        if (!(ray.tMin < ray.tMax)) break;
    }
    return transmittance;
}

}  // namespace luxdeck
