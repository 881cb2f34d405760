#pragma once

#include "engine/core/vec.h"
#include "engine/raycast/raycaster.h"
#include "engine/scene/needs.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

/// A point of a surface as a ray meets it. Every surface has two sides and the normals face the ray.
struct SurfacePoint {
    Vec3 position;            // from the triangle's vertices, not along the ray: rounding stays in the surface
    Vec3 geometricNormal;     // unit, towards where the ray came from
    Vec3 shadingNormal;       // unit, on the same side
    Vec2 uv{0, 0};
    bool frontFace = true;    // the mesh's own normal faces the ray
    float ulp = 0;            // spacing of floats at the position [m]
    const Material* material = nullptr;
    Vec3 rayDirection{0, 0, -1};  // of the ray that met it, unit
    float rayDistance = 0;        // along that ray [m]

    /// Where a ray that leaves to the side of `direction` starts: off the surface by some ulps, so that it
    /// cannot meet it again.
    [[nodiscard]] Vec3 departure(const Vec3& direction) const {
        const float offset = dot(direction, geometricNormal) >= 0 ? 16 * ulp : -16 * ulp;
        return position + geometricNormal * offset;
    }
    [[nodiscard]] PatternPoint patternPoint(const Scene& scene) const {
        return {scene.toUser(position), geometricNormal, rayDirection, double{rayDistance}, uv};
    }
};

/// The distance to the next float at the largest coordinate of p, at least that at 1 cm [m].
inline float spacingAt(const Vec3& p) {
    const float largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), 0.01F});
    return largest * 0x1.0p-23F;
}

SurfacePoint surfacePoint(const Scene& scene, const SceneNeeds& needs, const Ray& ray, const Hit& hit);

/// The frame in which the surface scatters: about its shading normal, x along the grain where it has one.
Frame surfaceFrame(const Scene& scene, const SurfacePoint& point, const Hit& hit);

}  // namespace luxdeck
