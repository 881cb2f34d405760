#include "engine/volume/visible_lookup.h"

#include "engine/volume/corners.h"

#include <algorithm>
#include <array>
#include <limits>

namespace luxdeck {

void VisibleLookup::lookFromCorners(const Lattice::Place& place, std::vector<Candidate>& out) const {
    const auto& corners = field_.volume().lattice.cells()[place.cell].vertices;
    const auto weights = trilinearWeights(place.fraction);
    out.clear();
    for (std::size_t i = 0; i < 8; ++i)
        if (field_.volume().quality[corners[i]].usable()) out.push_back({corners[i], std::max(weights[i], kLeastWeight)});
}

/// Corners of the cells that touch the point's own, weighed by the inverse square of their distance.
void VisibleLookup::lookAround(const Vec3& from, const Lattice::Place& place, std::vector<Candidate>& out) const {
    std::array<std::uint32_t, 216> vertices{};
    const std::size_t count = usableAround(field_.volume(), place.cell, vertices);
    out.clear();
    for (const auto v : std::span(vertices).first(count)) out.push_back({v, 1 / std::max((field_.volume().lattice.vertices()[v] - from).length2(), 1e-12F)});
}

void VisibleLookup::keepVisible(const Vec3& from, Work& work, LookupCounters& counters) const {
    work.rays.clear();
    for (const auto& c : work.candidates) work.rays.push_back(rayBetween(from, field_.volume().lattice.vertices()[c.vertex]));
    work.hidden.resize(work.rays.size());
    raycaster_.occluded(work.rays, work.hidden, Targets::Opaque);
    counters.rays += work.rays.size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < work.candidates.size(); ++i)
        if (work.hidden[i] == 0) work.candidates[kept++] = work.candidates[i];
    work.candidates.resize(kept);
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
    Work work;
    auto& candidates = work.candidates;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const auto look = field_.look(directions[i]);
        const Vec3 from = normals.empty() ? positions[i] : liftedOff(positions[i], normals[i]);
        const auto place = volume.lattice.locate(from);
        lookFromCorners(place, candidates);
        if (cornersMayBeHidden(volume, place, from)) keepVisible(from, work, counters);
        if (candidates.size() == 8) ++counters.whole;
        else if (!candidates.empty()) ++counters.part;
        else {
            lookAround(from, place, candidates);
            keepVisible(from, work, counters);
            ++(candidates.empty() ? counters.nothing : counters.neighbours);
        }
        values[i] = candidates.empty() ? Rgb(std::numeric_limits<float>::quiet_NaN()) : blend(candidates, look);
    }
    return counters;
}

}  // namespace luxdeck
