#include "engine/transport/irradiance_cache/surroundings.h"

#include "engine/sampling/sobol.h"
#include "engine/transport/irradiance_cache/hemisphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace luxdeck {

namespace {

constexpr HemisphereCells kAround{4, 16};
/// Of the two rays of a direction, to the surface: what is lower than a twentieth of its distance is a seam, a cable or the
/// edge of a tile; what ends above the surface, as many partitions do, the higher ray meets.
constexpr std::array<float, 2> kSines{0.05F, 0.26F};
/// A straight wall between two directions 14 degrees apart is nearer by up to 0.8 %.
constexpr float kNearer = 0.98F;

}  // namespace

Vec3 Horizon::direction(int k) {
    const float t = static_cast<float>(k) * 4 / kSectors;
    const float x = t < 2 ? 1 - t : t - 3, y = t < 1 ? t : t < 3 ? 2 - t : t - 4;
    return Vec3(x, y, 0).normalized();
}

float Horizon::sectorOf(float x, float y) {
    const float t = y / (std::abs(x) + std::abs(y) + 1e-30F);
    return (x < 0 ? 2 - t : t < 0 ? 4 + t : t) * (kSectors / 4);
}

Horizon::Tells Horizon::of(const Vec3& way) const {
    const int low = static_cast<int>(sectorOf(way.x, way.y)) % kSectors, high = (low + 1) % kSectors;
    const auto [nearest, furthest] = std::minmax(distance[static_cast<std::size_t>(low)], distance[static_cast<std::size_t>(high)]);
    const float away = std::sqrt(way.x * way.x + way.y * way.y);
    if (away < kNearer * nearest) return Tells::Seen;
    return away > furthest / kNearer ? Tells::Hidden : Tells::Nothing;
}

Surroundings lookAround(const Raycaster& raycaster, const Vec3& position, const Vec3& geometricNormal, std::uint64_t seed) {
    const auto frame = Frame::about(geometricNormal);
    std::vector<Ray> rays;
    for (int i = 0; i < kAround.count(); ++i) {
        SamplePath numbers(seed, static_cast<std::uint32_t>(i));
        rays.push_back({position, 0, frame.toWorld(kAround.direction(i, numbers.next2D())), kInfinity});
    }
    for (const float sine : kSines)
        for (int k = 0; k < Horizon::kSectors; ++k) {
            const Vec3 local = Horizon::direction(k) * std::sqrt(1 - sine * sine) + Vec3(0, 0, sine);
            rays.push_back({position, 0, frame.toWorld(local), kInfinity});
        }
    std::vector<Hit> hits(rays.size());
    raycaster.closestHits(rays, hits, Targets::Opaque);

    Surroundings out;
    std::vector<HemisphereCell> cells(static_cast<std::size_t>(kAround.count()));
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i].distance = hits[i].distance;
    out.meanDistance = harmonicMean(cells);
    for (std::size_t k = 0; k < Horizon::kSectors; ++k) {
        out.horizon.distance[k] = kInfinity;
        for (std::size_t i = 0; i < kSines.size(); ++i) {
            const float met = hits[cells.size() + i * Horizon::kSectors + k].distance * std::sqrt(1 - kSines[i] * kSines[i]);
            out.horizon.distance[k] = std::min(out.horizon.distance[k], met);
        }
    }
    return out;
}

}  // namespace luxdeck
