#include "engine/transport/sky_visibility.h"

#include <vector>

namespace luxdeck {

namespace {

class TracedVisibility : public SkyVisibility {
public:
    TracedVisibility(const Scene& scene, const Raycaster& raycaster) : scene_(scene), raycaster_(raycaster) {}

    void hidden(std::span<const SkyRay> rays, std::span<std::uint8_t> hidden) const override {
        std::vector<Ray> asked;
        asked.reserve(rays.size());
        for (const auto& r : rays) asked.push_back({r.origin, 0, r.direction, r.most});
        raycaster_.occluded(asked, hidden, Targets::Opaque);
    }

    [[nodiscard]] SkyObstacle nearest(const SkyRay& r) const override {
        const Ray ray{r.origin, 0, r.direction, r.most};
        Hit hit;
        raycaster_.closestHits({&ray, 1}, {&hit, 1}, Targets::Opaque);
        if (!hit.surface()) return {kInfinity, -r.direction};
        const auto& mesh = scene_.meshes[hit.mesh];
        const auto& [a, b, c] = mesh.triangles[hit.triangle];
        const Vec3 normal = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).normalized();
        return {hit.distance, dot(normal, r.direction) > 0 ? -normal : normal};
    }

private:
    const Scene& scene_;
    const Raycaster& raycaster_;
};

}  // namespace

std::unique_ptr<const SkyVisibility> makeSkyVisibility(const Scene& scene, const Raycaster& raycaster) {
    return std::make_unique<TracedVisibility>(scene, raycaster);
}

std::unique_ptr<SkySampler> makeSkySampler(const Scene& scene, const SceneNeeds& needs, const Raycaster& raycaster) {
    if (!needs.sky) return nullptr;
    auto sky = std::make_unique<SkySampler>(scene);
    if (sky->black()) return nullptr;
    sky->findVisible(makeSkyVisibility(scene, raycaster));
    return sky;
}

}  // namespace luxdeck
