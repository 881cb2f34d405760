#include "engine/volume/visible_lookup.h"

#include "engine/transport/surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace luxdeck {

void VisibleLookup::lookFromCorners(const Lattice::Place& place, std::vector<Candidate>& out) const {
    const auto& corners = field_.volume().lattice.cells()[place.cell].vertices;
    const Vec3& f = place.fraction;
    // A corner with no weight where the point lies on a side of the cell still counts when all others are hidden.
    constexpr float kLeast = 1e-6F;
    out.clear();
    for (std::uint32_t i = 0; i < 8; ++i) {
        const float w = ((i & 1U) != 0 ? f.x : 1 - f.x) * ((i & 2U) != 0 ? f.y : 1 - f.y) * ((i & 4U) != 0 ? f.z : 1 - f.z);
        if (field_.volume().quality[corners[i]].usable()) out.push_back({corners[i], std::max(w, kLeast)});
    }
}

/// Corners of the cells that touch the point's own, weighed by the inverse square of their distance.
void VisibleLookup::lookAround(const Vec3& from, const Lattice::Place& place, std::vector<Candidate>& out) const {
    const auto& lattice = field_.volume().lattice;
    const auto box = lattice.box(place.cell);
    const Vec3 middle = (box.min + box.max) * 0.5F, side = box.max - box.min;
    std::vector<std::uint32_t> vertices;
    for (int i = 0; i < 27; ++i) {
        const Vec3 step(static_cast<float>(i % 3 - 1), static_cast<float>(i / 3 % 3 - 1), static_cast<float>(i / 9 - 1));
        const auto cell = lattice.locate(middle + side * step).cell;
        for (const auto v : lattice.cells()[cell].vertices)
            if (field_.volume().quality[v].usable()) vertices.push_back(v);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    out.clear();
    for (const auto v : vertices) out.push_back({v, 1 / std::max((lattice.vertices()[v] - from).length2(), 1e-12F)});
}

void VisibleLookup::keepVisible(const Vec3& from, std::vector<Candidate>& candidates, LookupCounters& counters) const {
    std::vector<Ray> rays;
    for (const auto& c : candidates) {
        const Vec3 way = field_.volume().lattice.vertices()[c.vertex] - from;
        const float length = way.length();
        rays.push_back({from, 0, length > 0 ? way / length : Vec3(0, 0, 1), length});
    }
    std::vector<std::uint8_t> hidden(rays.size());
    raycaster_.occluded(rays, hidden, Targets::Opaque);
    counters.rays += rays.size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (hidden[i] == 0) candidates[kept++] = candidates[i];
    candidates.resize(kept);
}

Rgb VisibleLookup::blend(const std::vector<Candidate>& candidates, const VolumeField::Look& look) const {
    float sum = 0;
    Rgb value;
    for (const auto& c : candidates) sum += c.weight, value += field_.atVertex(c.vertex, look) * c.weight;
    return value * (1 / sum);
}

LookupCounters VisibleLookup::at(std::span<const Vec3> positions, std::span<const Vec3> directions, std::span<const Vec3> normals,
                                 std::span<Rgb> values) const {
    const auto& volume = field_.volume();
    LookupCounters counters;
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const auto look = field_.look(directions[i]);
        const Vec3 from = normals.empty() ? positions[i] : positions[i] + normals[i] * (16 * spacingAt(positions[i]));
        const auto place = volume.lattice.locate(from);
        lookFromCorners(place, candidates);
        // Beyond the lattice the segment to a corner leaves the cell, and may cross what the cell does not hold.
        const bool traced = volume.occupied[place.cell] != 0 || !volume.lattice.bounds().intersects(from);
        if (traced) keepVisible(from, candidates, counters);
        if (candidates.size() == 8) ++counters.whole;
        else if (!candidates.empty()) ++counters.part;
        else {
            lookAround(from, place, candidates);
            keepVisible(from, candidates, counters);
            ++(candidates.empty() ? counters.nothing : counters.neighbours);
        }
        values[i] = candidates.empty() ? Rgb(std::numeric_limits<float>::quiet_NaN()) : blend(candidates, look);
    }
    return counters;
}

}  // namespace luxdeck
