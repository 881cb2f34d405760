#pragma once

#include "engine/sampling/alias_table.h"
#include "engine/transport/radiance_estimator.h"
#include "engine/transport/tracer/irradiance_field.h"

#include <cstdint>
#include <vector>

namespace luxdeck {

/// Points spread over both sides of all surfaces that may be matte: most of them by area, some by its root, so that small
/// things and a room beside a large plain get a share.
class SurfacePoints {
public:
    SurfacePoints(const TransportScene& scene, std::uint64_t seed);

    /// No surface is matte.
    [[nodiscard]] bool empty() const { return triangles_.empty(); }
    /// The i-th of a quasi-random sequence.
    [[nodiscard]] FieldPoint at(std::uint32_t i) const;

private:
    struct Triangle {
        std::uint32_t mesh, triangle;
    };
    TransportScene scene_;
    std::uint64_t seed_;
    std::vector<Triangle> triangles_;
    AliasTable chances_;
};

}  // namespace luxdeck
