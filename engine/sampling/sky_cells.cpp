#include "engine/sampling/sky_cells.h"

#include "engine/core/rng.h"
#include "engine/sampling/warp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace luxdeck {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr std::uint64_t kSeed = 0x5c1e5;
constexpr int kProbes = 512;            // points that tell how enclosed a scene is
constexpr int kProbeRays = 8;
constexpr int kMostEscapes = 2;         // of kProbeRays, from an enclosed point
constexpr float kCellsPerFreePath = 6;
constexpr double kMostCells = 8192;
constexpr int kPointTries = 12;
constexpr int kRaysPerTexel = 3;
constexpr int kSunRays = 12;
constexpr float kNeighbourShare = 0.2F; // a texel that no ray found open counts so much of an open neighbour
constexpr float kAligned = 0.99F;       // cosine within which a normal counts as an axis

Vec2 next2D(RandomStream& random) {
    const auto x = static_cast<float>(random.uniform()), y = static_cast<float>(random.uniform());
    return {std::min(x, 0x1.fffffep-1F), std::min(y, 0x1.fffffep-1F)};
}

struct Probe {
    Vec3 position{0, 0, 0};
    std::vector<float> distances;  // to what the rays met
};

/// A random point of a mesh's random triangle, just off it, and how far its rays went.
Probe probeFrom(const Mesh& mesh, const SkyVisibility& visibility, RandomStream& random) {
    const auto& [a, b, c] = mesh.triangles[random.below(mesh.triangles.size())];
    const Vec3 p = mesh.positions[a], e = mesh.positions[b] - p, f = mesh.positions[c] - p;
    Vec2 u = next2D(random);
    if (u.x + u.y > 1) u = {1 - u.x, 1 - u.y};
    Vec3 normal = cross(e, f).normalized();
    if (random.uniform() < 0.5) normal = -normal;
    Probe probe;
    probe.position = p + e * u.x + f * u.y;
    const Vec3& q = probe.position;
    const float offset = 64 * 0x1.0p-23F * std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z), 0.01F});
    const auto frame = Frame::about(normal);
    for (int i = 0; i < kProbeRays; ++i) {
        const auto met = visibility.nearest({q + normal * offset, frame.toWorld(cosineHemisphere(next2D(random))), kFar});
        if (met.distance < kFar) probe.distances.push_back(met.distance);
    }
    return probe;
}

/// Lets half-open texels' neighbours be asked now and then: the rays were few and the cell is wide.
void spread(std::array<float, SkyMap::kTexels>& shares) {
    constexpr int side = static_cast<int>(SkyMap::kSide);
    const auto before = shares;
    for (int i = 0; i < static_cast<int>(SkyMap::kTexels); ++i) {
        const int inside = i % (side * side), x = inside % side, y = inside / side;
        float largest = 0;
        if (x > 0) largest = std::max(largest, before[static_cast<std::size_t>(i - 1)]);
        if (x + 1 < side) largest = std::max(largest, before[static_cast<std::size_t>(i + 1)]);
        if (y > 0) largest = std::max(largest, before[static_cast<std::size_t>(i - side)]);
        if (y + 1 < side) largest = std::max(largest, before[static_cast<std::size_t>(i + side)]);
        auto& share = shares[static_cast<std::size_t>(i)];
        share = std::max(share, kNeighbourShare * largest);
    }
}

}  // namespace

Facing facingOf(const Vec3& normal) {
    for (std::uint32_t f = 0; f < kFacings - 1; ++f)
        if (dot(normal, axisOf(Facing{f})) > kAligned) return Facing{f};
    return Facing::Any;
}

Vec3 axisOf(Facing facing) {
    if (facing == Facing::Any) return {0, 0, 0};
    const auto f = static_cast<std::uint32_t>(facing);
    Vec3 axis(0, 0, 0);
    axis[static_cast<int>(f / 2)] = f % 2 == 0 ? 1.0F : -1.0F;
    return axis;
}

SkyCells::SkyCells(const Scene& scene, std::span<const float> luminances, std::unique_ptr<const SkyVisibility> visibility)
    : luminances_(luminances.begin(), luminances.end()), visibility_(std::move(visibility)) {
    for (const auto& sun : scene.sky.suns)
        if (suns_.size() < std::tuple_size_v<decltype(SkyView::sunShare)>) suns_.push_back(sun.direction);
    findEnclosed(scene);
    const auto cells = static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(count_[2]);
    views_ = std::vector<std::atomic<const SkyView*>>(cells * kFacings);
}

SkyCells::~SkyCells() {
    for (auto& view : views_) delete view.load();
}

/// The enclosed part is where points of surfaces see little of the outside, and a cell a fraction of how far light
/// goes there: neither depends on how large the ground around a building is drawn, nor on its unit.
void SkyCells::findEnclosed(const Scene& scene) {
    std::vector<const Mesh*> meshes;
    for (const auto& mesh : scene.meshes)
        if (!mesh.triangles.empty()) meshes.push_back(&mesh);
    if (meshes.empty()) return;
    RandomStream random(kSeed);
    Box3 box;
    std::vector<float> distances;
    for (std::size_t i = 0; i < kProbes; ++i) {
        const auto probe = probeFrom(*meshes[i * meshes.size() / kProbes % meshes.size()], *visibility_, random);
        if (probe.distances.size() < kProbeRays - kMostEscapes) continue;
        box.extendBy(probe.position);
        distances.insert(distances.end(), probe.distances.begin(), probe.distances.end());
    }
    if (distances.empty()) return;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    const Vec3d extent = Vec3d(box.size()) + Vec3d(*middle / kCellsPerFreePath);  // half a cell around
    const double volume = extent.x * extent.y * extent.z;
    const double edge = std::max(*middle / static_cast<double>(kCellsPerFreePath), std::cbrt(volume / kMostCells));
    if (!(edge > 0) || !std::isfinite(edge)) return;
    size_ = static_cast<float>(edge);
    low_ = box.min - Vec3(size_ / 2);
    for (int a = 0; a < 3; ++a)
        count_[static_cast<std::size_t>(a)] = static_cast<int>(std::min(kMostCells, std::ceil((box.max[a] - box.min[a]) / edge + 1)));
}

const SkyView* SkyCells::view(const Receiver& at) const {
    std::size_t cell = 0;
    for (int a = 2; a >= 0; --a) {
        const float x = std::floor((at.position[a] - low_[a]) / size_);
        const int count = count_[static_cast<std::size_t>(a)];
        if (!(x >= 0 && x < static_cast<float>(count))) return nullptr;
        cell = cell * static_cast<std::size_t>(count) + static_cast<std::size_t>(x);
    }
    const auto facing = facingOf(at.normal);
    auto& slot = views_[cell * kFacings + static_cast<std::size_t>(facing)];
    if (const auto* known = slot.load(std::memory_order_acquire)) return known;
    auto made = compute(cell, facing);
    const SkyView* expected = nullptr;
    if (slot.compare_exchange_strong(expected, made.get(), std::memory_order_acq_rel)) return made.release();
    return expected;  // another thread was faster, with the same numbers
}

std::unique_ptr<SkyView> SkyCells::compute(std::size_t cell, Facing facing) const {
    auto view = std::make_unique<SkyView>();
    const auto points = pointsOf(cell, facing);
    weighTexels(cell, facing, points, *view);
    weighSuns(facing, points, *view);
    return view;
}

std::vector<Vec3> SkyCells::pointsOf(std::size_t cell, Facing facing) const {
    RandomStream random(streamSeed(kSeed, cell * kFacings + static_cast<std::size_t>(facing), 1));
    const auto nx = static_cast<std::size_t>(count_[0]), ny = static_cast<std::size_t>(count_[1]);
    const Vec3 corner = low_ + Vec3(static_cast<float>(cell % nx), static_cast<float>(cell / nx % ny), static_cast<float>(cell / nx / ny)) * size_;
    const Vec3 axis = axisOf(facing);
    std::vector<Vec3> free, onSurfaces;
    for (int i = 0; i < kPointTries; ++i) {
        const auto x = static_cast<float>(random.uniform()), y = static_cast<float>(random.uniform()), z = static_cast<float>(random.uniform());
        const Vec3 p = corner + Vec3(x, y, z) * size_;
        free.push_back(p);
        if (facing == Facing::Any) continue;
        const float depth = dot(p - corner, axis) + (dot(axis, Vec3(1.0F)) < 0 ? size_ : 0);  // of the cell behind the point
        const auto met = visibility_->nearest({p, -axis, depth});
        if (met.distance <= depth && dot(met.normal, axis) > kAligned) onSurfaces.push_back(p - axis * (met.distance * 0.999F));
    }
    return onSurfaces.empty() ? free : onSurfaces;
}

void SkyCells::weighTexels(std::size_t cell, Facing facing, const std::vector<Vec3>& points, SkyView& view) const {
    RandomStream random(streamSeed(kSeed, cell * kFacings + static_cast<std::size_t>(facing), 2));
    const Vec3 axis = axisOf(facing);
    const auto weightOf = [&](std::uint32_t texel) {
        return facing == Facing::Any ? 0.5F : std::max(0.0F, dot(SkyMap::centre(texel), axis) + 0.05F);
    };
    std::vector<SkyRay> rays;
    std::vector<std::uint32_t> texels;
    for (std::uint32_t t = 0; t < SkyMap::kTexels; ++t) {
        if (!(luminances_[t] > 0) || !(weightOf(t) > 0)) continue;
        for (int k = 0; k < kRaysPerTexel; ++k) {
            const auto& from = points[random.below(points.size())];
            rays.push_back({from, SkyMap::direction(t, next2D(random)), kFar});
            texels.push_back(t);
        }
    }
    std::vector<std::uint8_t> hidden(rays.size());
    visibility_->hidden(rays, hidden);
    std::array<float, SkyMap::kTexels> weights{};
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (hidden[i] == 0) weights[texels[i]] += 1.0F / kRaysPerTexel;
    for (std::uint32_t t = 0; t < SkyMap::kTexels; ++t)
        view.lux += weights[t] * luminances_[t] * weightOf(t) * SkyMap::kTexelSr;
    spread(weights);
    for (std::uint32_t t = 0; t < SkyMap::kTexels; ++t) weights[t] *= luminances_[t] * weightOf(t);
    view.table = SkyTable(weights);
}

void SkyCells::weighSuns(Facing facing, const std::vector<Vec3>& points, SkyView& view) const {
    for (std::size_t s = 0; s < suns_.size(); ++s) {
        view.sunShare[s] = 0;
        if (facing != Facing::Any && dot(axisOf(facing), suns_[s]) < -0.15F) continue;
        std::vector<SkyRay> rays;
        for (std::size_t i = 0; i < kSunRays; ++i) rays.push_back({points[i % points.size()], suns_[s], kFar});
        std::vector<std::uint8_t> hidden(rays.size());
        visibility_->hidden(rays, hidden);
        for (const auto h : hidden) view.sunShare[s] += h == 0 ? 1.0F / kSunRays : 0.0F;
    }
}

}  // namespace luxdeck
