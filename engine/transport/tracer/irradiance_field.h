#pragma once

#include "engine/core/rgb.h"
#include "engine/core/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace luxdeck {

/// A place on a matte surface whose reflected light is asked of a field.
struct FieldPoint {
    Vec3 position{0, 0, 0};    // just off the surface, on the side asked for [m], re-based
    Vec3 normal{0, 0, 1};      // of shading, unit, to that side
    Vec3 geometricNormal{0, 0, 1};
    std::uint32_t mesh = 0;    // index into Scene::meshes
    std::uint32_t triangle = 0;
    float u = 0, v = 0;        // barycentric weights of its second and third vertex
    bool frontFace = true;     // the side of the mesh's own normal
};

/// What a path makes of a field's answer: the query's radiance grows by weight * lux.
struct FieldLink {
    FieldPoint point;
    Rgb weight;                // [cd/m^2 for each lx]
    std::uint32_t query = 0;   // index into the batch
    bool lost = false;         // of a path beyond a surface without a value: a part of RadianceSample::lost
};

/// Light on surfaces that was found before: what the cached algorithms (photon map, radiosity, irradiance cache,
/// volume) know. Biased, as its card says. Immutable, safe to call from any number of threads.
class IrradianceField {
public:
    virtual ~IrradianceField() = default;
    /// lux[i] becomes the indirect irradiance at points[i], reflected once or more, mirrors included [lx]; a value that
    /// is not finite rejects the sample. Both #P.
    virtual void indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const = 0;
    /// Something without a value was met while it was made: its light lacks what came from there.
    [[nodiscard]] virtual bool hasGaps() const { return false; }
    /// lux[i] becomes the most that indirect() may lack at points[i], as RadianceSample::lost; infinite: nothing is known.
    /// Both #P; zero without gaps.
    virtual void gaps(std::span<const FieldPoint> points, std::span<Rgb> lux) const {
        for (std::size_t i = 0; i < points.size(); ++i) lux[i] = Rgb{};
    }
};

}  // namespace luxdeck
