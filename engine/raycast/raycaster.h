#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>

namespace luxdeck {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr std::uint32_t kNothing = 0xffffffffU;

struct Ray {
    Vec3 origin{0, 0, 0};   // [m], re-based
    float tMin = 0;         // >= 0
    Vec3 direction{0, 0, 1};// unit
    float tMax = kInfinity;
};

/// What a ray met first. A triangle (mesh, triangle, u, v), or a luminaire's opening, or nothing.
struct Hit {
    float distance = kInfinity;          // along the ray [m]
    std::uint32_t mesh = kNothing;       // index into Scene::meshes
    std::uint32_t triangle = kNothing;
    std::uint32_t luminaire = kNothing;  // index into Scene::luminaires when an opening was met
    float u = 0;                         // barycentric weights of the triangle's second
    float v = 0;                         //   and third vertex
    bool badRay = false;                 // NaN, infinite or a negative start: not traced, to be counted

    [[nodiscard]] bool surface() const { return mesh != kNothing; }
    [[nodiscard]] bool opening() const { return luminaire != kNothing; }
};

/// Which things a ray can meet. Openings give light but hide nothing, panes let shadow rays through.
enum class Targets : std::uint32_t { Opaque = 1, Panes = 2, Openings = 4, Surfaces = 3, Everything = 7 };

/// Answers rays, in batches. Immutable after creation, safe to call from any number of threads. Memory of
/// the scene is used, not copied, where the kernel allows it: the scene must outlive the raycaster.
class Raycaster {
public:
    virtual ~Raycaster() = default;

    /// hits[i] becomes what rays[i] meets first; both #R.
    virtual void closestHits(std::span<const Ray> rays, std::span<Hit> hits, Targets targets) const = 0;
    /// occluded[i] becomes 1 when anything of `targets` lies on rays[i] between tMin and tMax; both #R.
    /// A bad ray counts as occluded.
    virtual void occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded, Targets targets) const = 0;

    /// "Embree 3.13.5, assertions on" ...
    [[nodiscard]] virtual std::string kernel() const = 0;
    /// Bytes that the acceleration structure takes.
    [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// The fast one.
///
/// errors  OutOfResources when the kernel cannot get its memory
Result<std::unique_ptr<Raycaster>> makeEmbreeRaycaster(const Scene& scene);

/// The oracle: every ray against every triangle in double precision, watertight. For tests.
std::unique_ptr<Raycaster> makeBruteForceRaycaster(const Scene& scene);

/// A ray that may be given to a kernel: all finite (tMax may be infinite), tMin >= 0.
inline bool isGood(const Ray& ray) {
    const float sum = ray.origin.x + ray.origin.y + ray.origin.z + ray.direction.x + ray.direction.y + ray.direction.z;
    return sum * 0.0F == 0.0F && ray.tMin >= 0.0F && ray.tMax >= 0.0F;  // inf * 0 and NaN * 0 are NaN
}

}  // namespace luxdeck
