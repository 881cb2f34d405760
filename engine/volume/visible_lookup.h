#pragma once

#include "engine/raycast/raycaster.h"
#include "engine/volume/field.h"

#include <cstdint>
#include <span>
#include <vector>

namespace luxdeck {

/// How much of what a point should be interpolated from it could be.
struct LookupCounters {
    std::uint64_t whole = 0;      // all eight corners counted
    std::uint64_t part = 0;       // some did: the others lie behind a surface, or inside a solid
    std::uint64_t neighbours = 0; // none did, but vertices of cells around
    std::uint64_t nothing = 0;    // no vertex near sees the point: its value is not known (NaN)
    std::uint64_t rays = 0;

    LookupCounters& operator+=(const LookupCounters& o) {
        whole += o.whole, part += o.part, neighbours += o.neighbours, nothing += o.nothing, rays += o.rays;
        return *this;
    }
};

/// Trilinear interpolation from those corners alone that see the point: light does not leak through walls. In a cell
/// without geometry all do, and nothing is traced. In others a corner counts when it is usable and nothing opaque lies
/// between; the weights of the rest are scaled up. Where no corner sees the point, vertices of the cells around are asked.
///
/// The field, its volume and the raycaster of the same scene must outlive it. Safe to ask from any number of threads.
class VisibleLookup {
public:
    VisibleLookup(const VolumeField& field, const Raycaster& raycaster) : field_(field), raycaster_(raycaster) {}

    /// As VolumeField::at(). normals: a surface's, along which its points are lifted off by a hair before they are looked
    /// from; empty: points in free space. NaN where nothing is known.
    LookupCounters at(std::span<const Vec3> positions, std::span<const Vec3> directions, std::span<const Vec3> normals, std::span<Rgb> values) const;

private:
    struct Candidate {
        std::uint32_t vertex;
        float weight;
    };

    /// What one call works with, used again for each of its points.
    struct Work {
        std::vector<Candidate> candidates;
        std::vector<Ray> rays;
        std::vector<std::uint8_t> hidden;
    };

    void lookFromCorners(const Lattice::Place& place, std::vector<Candidate>& out) const;
    void lookAround(const Vec3& from, const Lattice::Place& place, std::vector<Candidate>& out) const;
    void keepVisible(const Vec3& from, Work& work, LookupCounters& counters) const;
    [[nodiscard]] Rgb blend(const std::vector<Candidate>& candidates, const VolumeField::Look& look) const;

    const VolumeField& field_;
    const Raycaster& raycaster_;
};

}  // namespace luxdeck
