#include "engine/volume/volume_update.h"

#include "engine/core/rng.h"
#include "engine/volume/volume_file.h"

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

constexpr int kLooks = 64;        // rays to a box: what is smaller than a 64th of it as seen may be overlooked
constexpr std::size_t kChecked = 24;

std::array<float, 3> placeOf(const Vec3& p) { return {p.x, p.y, p.z}; }

}  // namespace

VolumeUpdate::VolumeUpdate(const IrradianceVolume& old, const TransportScene& scene, VertexStore* journal)
    : old_(old), scene_(scene), journal_(journal), changes_(sceneChanges(old, scene.scene)) {
    for (std::uint32_t v = 0; v < old.vertexCount(); ++v) vertexOf_[placeOf(old.lattice.vertices()[v])] = v;
    const auto now = contentParts(scene.scene);
    const auto unmatched = [&](const std::vector<ContentPart>& parts, const std::vector<ContentPart>& others) {
        for (const auto& part : parts) {
            const bool same = std::any_of(others.begin(), others.end(), [&](const auto& o) { return o.name == part.name && o.hash == part.hash; });
            if (same) continue;
            const bool object = part.name.starts_with("object ") && !part.bounds.isEmpty();
            if (object) moved_.push_back(part.bounds);
            else everything_ = true;
        }
    };
    unmatched(old.parts, now), unmatched(now, old.parts);
}

/// Whether anything of the box can be seen. What stands in it now does not hide it.
bool VolumeUpdate::sees(const Vec3& position, const Box3& box) const {
    if (box.intersects(position)) return true;
    RandomStream random(placeHash(position));
    std::vector<Ray> rays;
    for (int i = 0; i < kLooks; ++i) {
        const auto within = [&](int axis) { return box.min[axis] + static_cast<float>(random.uniform()) * (box.max[axis] - box.min[axis]); };
        const Vec3 way = Vec3(within(0), within(1), within(2)) - position;
        const float length = way.length();
        if (length > 0) rays.push_back({position, 0, way / length, length});
    }
    std::vector<Hit> hits(rays.size());
    scene_.raycaster.closestHits(rays, hits, Targets::Opaque);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3 met = rays[i].origin + rays[i].direction * hits[i].distance;
        if (!hits[i].surface() || hits[i].distance >= rays[i].tMax || box.intersects(met)) return true;
    }
    return false;
}

bool VolumeUpdate::affected(const Vec3& position) const {
    return everything_ || std::any_of(moved_.begin(), moved_.end(), [&](const Box3& box) { return sees(position, box); });
}

std::optional<VertexState> VolumeUpdate::find(const Vec3& position) {
    if (journal_ != nullptr)
        if (auto known = journal_->find(position)) return known;
    const auto found = vertexOf_.find(placeOf(position));
    if (found == vertexOf_.end() || affected(position)) return std::nullopt;
    if (old_.quality[found->second].samples == 0) return std::nullopt;
    ++kept_;
    return stateOf(old_, found->second);
}

Result<void> VolumeUpdate::keep(std::span<const Vec3> positions, std::span<const VertexState> states) {
    return journal_ != nullptr ? journal_->keep(positions, states) : Result<void>{};
}

VolumeUpdate::Deviation VolumeUpdate::measureKept(const IrradianceVolume& updated, const VertexSampler& sampler) const {
    std::vector<std::uint32_t> keptVertices;
    for (std::uint32_t v = 0; v < updated.vertexCount(); ++v) {
        const auto found = vertexOf_.find(placeOf(updated.lattice.vertices()[v]));
        if (found != vertexOf_.end() && updated.quality[v].usable() && old_.quality[found->second].lux == updated.quality[v].lux && !affected(updated.lattice.vertices()[v]))
            keptVertices.push_back(v);
    }
    Deviation out;
    double off2 = 0, lux2 = 0;
    for (std::size_t i = 0; i < std::min(kChecked, keptVertices.size()); ++i) {
        const auto v = keptVertices[i * keptVertices.size() / std::min(kChecked, keptVertices.size())];
        // The same random numbers: noise that the change does not touch cancels.
        VertexState again;
        TransportCounters counters;
        sampler.sample(updated.lattice.vertices()[v], updated.quality[v].samples, again, counters);
        for (std::size_t axis = 0; axis < 6; ++axis) {
            const double x = again.quality.lux[axis], y = updated.quality[v].lux[axis];
            off2 += (x - y) * (x - y), lux2 += x * x;
        }
        ++out.vertices;
    }
    out.relative = lux2 > 0 ? std::sqrt(off2 / lux2) : 0;
    return out;
}

}  // namespace luxdeck
