#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/transport/surface/surface_elements.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace luxdeck {

/// What arrived on an element.
struct ElementPhotons {
    Rgb power;                 // [lm]
    std::uint32_t count = 0;
};

/// Density of photons about each element: the power that arrived on the elements within a disc, over their area.
///
/// Elements count that are of the same mesh, face the same way, lie in the disc's plane and are seen from its middle just above
/// the surface: walls end a disc, and the slab below a carpet is not the carpet. Since the area is that of the elements themselves, a disc that hangs over an edge loses nothing. An
/// element without photons among many that have them lies hidden, under a cupboard or within a wall, and does not count; of
/// the others counts the part from which there is a way out of a small gap.
class PhotonDensity {
public:
    /// discElements  elements of its own size that a disc has room for, >= 1
    PhotonDensity(const TransportScene& scene, const SurfaceElements& elements, std::span<const ElementPhotons> photons, double discElements,
                  std::uint64_t seed);

    /// [lx]
    [[nodiscard]] Rgb lux(std::uint32_t element) const;

private:
    struct Middle {
        Vec3 position{0, 0, 0};
        Vec3 normal{0, 0, 1};
    };
    [[nodiscard]] std::vector<std::uint32_t> inDisc(std::uint32_t element) const;
    void dropUnseen(std::uint32_t element, float radius, std::vector<std::uint32_t>& others) const;
    [[nodiscard]] float radiusOf(std::uint32_t element) const;
    [[nodiscard]] float openAreaM2(std::uint32_t element, std::uint64_t seed) const;
    [[nodiscard]] std::uint64_t cellOf(const Vec3& position, int dx, int dy, int dz) const;

    const TransportScene& scene_;
    const SurfaceElements& elements_;
    std::span<const ElementPhotons> photons_;
    float discElements_;
    float cellM_ = 1;
    std::vector<Middle> middles_;
    std::vector<float> openM2_;          // of each element that has photons
    std::vector<std::uint32_t> order_;   // elements by cell
    struct Run {
        std::uint32_t first = 0, last = 0;
    };
    std::unordered_map<std::uint64_t, Run> cells_;
};

}  // namespace luxdeck
