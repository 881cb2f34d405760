#include "analysis/furniture/self_shade.h"

#include "engine/core/parallel.h"
#include "engine/core/rng.h"
#include "engine/sampling/sobol.h"
#include "engine/sampling/warp.h"
#include "engine/transport/surface/surface_point.h"

#include <algorithm>
#include <optional>

namespace luxdeck {

namespace {

constexpr std::uint64_t kSeed = 0x5e1f;  // the object's own frame: whatever the user's seed, it hides the same

std::optional<SelfShade::Row> look(const MovableObject& object, const ObjectRays& rays, const DirectionBins& bins, std::size_t v) {
    std::array<Ray, SelfShade::kRays> ways{};
    std::array<Hit, SelfShade::kRays> hits{};
    const Vec3 from = object.positions[v] + object.normals[v] * (16 * spacingAt(object.positions[v]));
    const Frame frame = Frame::about(object.normals[v]);
    for (std::uint32_t i = 0; i < SelfShade::kRays; ++i) {
        SamplePath numbers(streamSeed(kSeed, v), i);
        ways[i] = {from, 0, frame.toWorld(cosineHemisphere(numbers.next2D())), kInfinity};
    }
    rays.raycaster().closestHits(ways, hits, Targets::Opaque);
    SelfShade::Row row;
    std::array<std::uint32_t, SelfShade::kRays> seen{};
    std::uint32_t hidden = 0;
    for (std::uint32_t i = 0; i < SelfShade::kRays; ++i) {
        const auto bin = static_cast<std::size_t>(bins.binOf(ways[i].direction));
        ++row.all[bin];
        if (!hits[i].surface()) continue;
        ++row.hidden[bin];
        const auto met = rays.vertexAt(hits[i]);
        seen[hidden++] = dot(object.normals[met], ways[i].direction) < 0 ? met : SelfShade::kOpen;
    }
    if (hidden == 0) return std::nullopt;
    row.hiddenPart = static_cast<float>(hidden) / SelfShade::kRays;
    row.linkCount = static_cast<std::uint8_t>(std::min<std::size_t>(hidden, SelfShade::kLinks));
    for (std::size_t k = 0; k < row.linkCount; ++k) row.links[k] = seen[k * hidden / row.linkCount];
    return row;
}

}  // namespace

Result<ObjectRays> ObjectRays::create(const MovableObject& object) {
    ObjectRays out;
    out.scene_ = std::make_unique<Scene>();
    auto& scene = *out.scene_;
    scene.materials.emplace_back();
    scene.objects.push_back({object.name, true});
    Mesh mesh;
    mesh.positions = object.positions;
    for (std::size_t t = 0; t < object.triangles.size(); ++t)
        if (object.solid[t] != 0) mesh.triangles.push_back(object.triangles[t]);
    scene.meshes.push_back(std::move(mesh));
    auto raycaster = makeEmbreeRaycaster(scene);
    if (!raycaster) return raycaster.error();
    out.raycaster_ = *std::move(raycaster);
    return out;
}

std::uint32_t ObjectRays::vertexAt(const Hit& hit) const {
    const auto& t = scene_->meshes[hit.mesh].triangles[hit.triangle];
    const float first = 1 - hit.u - hit.v;
    return first >= hit.u && first >= hit.v ? t[0] : hit.u >= hit.v ? t[1] : t[2];
}

SelfShade::SelfShade(const MovableObject& object, const ObjectRays& rays) {
    const std::size_t count = object.positions.size();
    const DirectionBins bins(kSide);
    constexpr std::size_t kBlock = 4096;  // rows of vertices that see everything are not kept
    index_.assign(count, kOpen);
    std::vector<std::optional<Row>> block(std::min(count, kBlock));
    for (std::size_t first = 0; first < count; first += kBlock) {
        const std::size_t size = std::min(kBlock, count - first);
        parallelFor(size, [&](std::size_t i) { block[i] = look(object, rays, bins, first + i); });
        for (std::size_t i = 0; i < size; ++i)
            if (block[i]) index_[first + i] = static_cast<std::uint32_t>(rows_.size()), rows_.push_back(*block[i]);
    }
}

}  // namespace luxdeck
