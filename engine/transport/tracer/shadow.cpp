#include "engine/transport/tracer/shadow.h"

#include "engine/transport/surface/glass.h"
#include "engine/transport/surface/surface_point.h"

#include <cmath>

namespace luxdeck {

Rgb paneTransmittance(const TransportScene& scene, Ray ray, TransportCounters& counters) {
    Rgb transmittance(1.0F);
    std::uint32_t lastMesh = kNothing;
    float lastDistance = 0;
    while (!transmittance.isBlack()) {
        Hit hit;
        scene.raycaster.closestHits({&ray, 1}, {&hit, 1}, Targets::Panes);
        ++counters.rays;
        if (!hit.surface()) break;
        const auto point = surfacePoint(scene.scene, scene.needs, ray, hit);
        const float spacing = 8 * (point.ulp + hit.distance * 0x1.0p-23F);
        if (hit.mesh != lastMesh || hit.distance - lastDistance > spacing) {
            const float cosine = std::abs(dot(point.geometricNormal, ray.direction));
            transmittance *= paneLight(point.material->transmittance, point.material->ior, cosine).transmitted;
        }
        lastMesh = hit.mesh, lastDistance = hit.distance;
        ray.tMin = std::nextafter(hit.distance, kInfinity);
        if (!(ray.tMin < ray.tMax)) break;
    }
    return transmittance;
}

}  // namespace luxdeck
