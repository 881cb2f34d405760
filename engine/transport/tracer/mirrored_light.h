#pragma once

#include "engine/sampling/mirrors.h"
#include "engine/transport/radiance_estimator.h"

#include <optional>
#include <vector>

namespace luxdeck {

/// A light seen in a flat mirror or pane: from the receiver to the mirror, and on to the light.
struct MirrorPath {
    std::uint32_t mirror = kNoMirror;
    Vec3 direction{0, 0, 1};  // from the receiver towards the mirrored image, unit
    float toMirror = 0;       // [m]
    float toLight = 0;        // along the whole way [m]
    LightSample light;        // chosen for the receiver behind the mirror
};

/// Whether any light is sought by way of mirrors: lamps, emitting surfaces and suns are.
bool seeksByMirrors(const TransportScene& scene);

/// The mirrored receiver's choice of a light, turned back into this world. Nothing when there is none, when the
/// light does not lie on the receiver's side of the mirror, or when both strategies share it: directions that
/// receivers choose find those lights well enough, mirrored or not, and count for them in full.
std::optional<MirrorPath> aimByMirror(const TransportScene& scene, const Receiver& at, std::uint32_t mirror, const LightSampler::Weights& weights,
                                      float uSelect, Vec2 u);

/// What arrives of the light's radiance by that way: 0 where something opaque stands in it, or where the mirror has
/// no glass.
Rgb throughputByMirror(const TransportScene& scene, const Vec3& origin, const MirrorPath& path, TransportCounters& counters);

/// Whether next-event estimation by way of the mirror has the light that was met, an opening, to itself.
inline bool foundByMirror(const TransportScene& scene, const Receiver& at, std::uint32_t mirror, const Hit& opening, const Vec3& direction) {
    const auto behind = scene.mirrors.all()[mirror].mirrored(at);
    return scene.lights.pdfOpening(behind, opening.luminaire, direction) == kInfinity;
}
/// The same for an emitting triangle.
inline bool foundByMirror(const TransportScene& scene, const Receiver& at, std::uint32_t mirror, const Hit& triangle, float cosine, float distance) {
    const auto behind = scene.mirrors.all()[mirror].mirrored(at);
    return scene.lights.pdfTriangle(behind, triangle.mesh, triangle.triangle, distance, cosine) == kInfinity;
}

/// The mirrors as one place sees them: which of them shows how much light.
class MirrorTable {
public:
    MirrorTable(const TransportScene& scene, const Receiver& at);

    /// One mirror, with the weights of the lights in it.
    struct Choice {
        std::uint32_t mirror = kNoMirror;
        float probability = 0;
        const LightSampler::Weights* weights = nullptr;
    };
    [[nodiscard]] Choice choose(float& u) const;

private:
    std::vector<LightSampler::Weights> weights_;
    std::vector<float> chances_;
};

}  // namespace luxdeck
