#include "engine/transport/photon_map/photon_density.h"

#include "engine/core/parallel.h"
#include "engine/core/rng.h"
#include "engine/sampling/warp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace luxdeck {

namespace {

constexpr float kSameWay = 0.9F;      // cosine between normals that face the same way
constexpr float kInPlane = 0.2F;      // of the radius: height above the disc
constexpr float kAbove = 0.05F;       // of the radius: where the elements look at each other
constexpr double kSurelyFull = 6;     // photons expected; none come with a chance of 0.25 %
constexpr float kGap = 0.15F;         // of the radius: nothing is seen of what lies in a gap less wide
constexpr std::uint32_t kOpenPoints = 4, kOpenRays = 6;  // of an element
constexpr std::size_t kTask = 256;    // elements
constexpr double kTypical = 0.5;      // the quantile of elements whose disc is as wide as a cell

}  // namespace

PhotonDensity::PhotonDensity(const TransportScene& scene, const SurfaceElements& elements, std::span<const ElementPhotons> photons, double discElements,
                             std::uint64_t seed)
    : scene_(scene), elements_(elements), photons_(photons), discElements_(static_cast<float>(discElements)) {
    if (elements.size() == 0) return;
    std::vector<float> areas;
    for (std::size_t e = 0; e < elements.size(); e += 2) areas.push_back(elements.areaM2(e));
    const auto typical = areas.begin() + static_cast<std::ptrdiff_t>(kTypical * static_cast<double>(areas.size() - 1));
    std::nth_element(areas.begin(), typical, areas.end());
    cellM_ = std::sqrt(discElements_ * *typical / kPi);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    for (std::uint32_t e = 0; e < elements.size(); ++e) {
        const auto at = elements.place(e, {0.5F, 0.5F});
        middles_.push_back({at.position, at.geometricNormal});
        keys.emplace_back(cellOf(at.position, 0, 0, 0), e);
    }
    std::sort(keys.begin(), keys.end());
    for (std::uint32_t i = 0; i < keys.size(); ++i) {
        order_.push_back(keys[i].second);
        auto& run = cells_.try_emplace(keys[i].first, Run{i, i}).first->second;
        run.last = i + 1;
    }
    openM2_.resize(elements.size());
    parallelFor((elements.size() + kTask - 1) / kTask, [&](std::size_t task) {
        for (std::size_t e = task * kTask; e < std::min(elements.size(), (task + 1) * kTask); ++e)
            if (photons[e].count > 0) openM2_[e] = openAreaM2(static_cast<std::uint32_t>(e), seed);
    });
}

/// The part of an element where one of a few directions leads further than a gap is wide.
float PhotonDensity::openAreaM2(std::uint32_t element, std::uint64_t seed) const {
    const float gap = kGap * radiusOf(element);
    std::array<Ray, kOpenPoints * kOpenRays> rays;
    for (std::uint32_t i = 0; i < rays.size(); ++i) {
        SamplePath places(streamSeed(seed, element, 1), i / kOpenRays), directions(streamSeed(seed, element, 2), i);
        const auto at = elements_.place(element, places.next2D());
        const Vec3 way = Frame::about(at.geometricNormal).toWorld(cosineHemisphere(directions.next2D()));
        rays[i] = {at.departure(way), 0, way, gap};
    }
    std::array<std::uint8_t, kOpenPoints * kOpenRays> hidden{};
    scene_.raycaster.occluded(rays, hidden, Targets::Opaque);
    int open = 0;
    for (std::uint32_t p = 0; p < kOpenPoints; ++p)
        if (std::count(hidden.begin() + p * kOpenRays, hidden.begin() + (p + 1) * kOpenRays, 0) > 0) ++open;
    return elements_.areaM2(element) * static_cast<float>(std::max(open, 1)) / kOpenPoints;
}

std::uint64_t PhotonDensity::cellOf(const Vec3& p, int dx, int dy, int dz) const {
    const auto cell = [&](float x) { return static_cast<std::int64_t>(std::floor(double{x} / double{cellM_})); };
    const auto key = streamSeed(static_cast<std::uint64_t>(cell(p.x) + dx), static_cast<std::uint64_t>(cell(p.y) + dy));
    return streamSeed(key, static_cast<std::uint64_t>(cell(p.z) + dz));
}

/// As wide as its elements are, but not far beyond the cells around: very large elements stay alone.
float PhotonDensity::radiusOf(std::uint32_t element) const {
    return std::min(std::sqrt(discElements_ * elements_.areaM2(element) / kPi), cellM_);
}

std::vector<std::uint32_t> PhotonDensity::inDisc(std::uint32_t element) const {
    const auto& here = middles_[element];
    const float radius = radiusOf(element);
    std::vector<std::uint32_t> found;
    for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dz = -1; dz <= 1; ++dz) {
                const auto run = cells_.find(cellOf(here.position, dx, dy, dz));
                if (run == cells_.end()) continue;
                for (auto i = run->second.first; i < run->second.last; ++i) {
                    const auto& there = middles_[order_[i]];
                    const Vec3 way = there.position - here.position;
                    if (order_[i] != element && elements_.mesh(order_[i]) == elements_.mesh(element) && way.length2() <= radius * radius && dot(there.normal, here.normal) >= kSameWay &&
                        std::abs(dot(way, here.normal)) <= kInPlane * radius)
                        found.push_back(order_[i]);
                }
            }
    return found;
}

void PhotonDensity::dropUnseen(std::uint32_t element, float radius, std::vector<std::uint32_t>& others) const {
    const auto above = [&](std::uint32_t e) { return middles_[e].position + middles_[e].normal * (kAbove * radius + 16 * spacingAt(middles_[e].position)); };
    std::vector<Ray> rays;
    for (const auto other : others) {
        const Vec3 way = above(other) - above(element);
        const float length = way.length();
        rays.push_back({above(element), 0, length > 0 ? way / length : middles_[element].normal, length});
    }
    std::vector<std::uint8_t> hidden(rays.size());
    scene_.raycaster.occluded(rays, hidden, Targets::Opaque);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < others.size(); ++i)
        if (hidden[i] == 0) others[kept++] = others[i];
    others.resize(kept);
}

Rgb PhotonDensity::lux(std::uint32_t element) const {
    auto disc = inDisc(element);
    const bool any = photons_[element].count > 0 || std::any_of(disc.begin(), disc.end(), [&](std::uint32_t e) { return photons_[e].count > 0; });
    if (!any) return Rgb{};
    dropUnseen(element, radiusOf(element), disc);
    disc.push_back(element);
    double count = 0, area = 0;  // of those that have photons
    for (const auto e : disc)
        if (photons_[e].count > 0) count += photons_[e].count, area += double{elements_.areaM2(e)};
    if (!(area > 0)) return Rgb{};
    Rgb power;
    double open = 0;
    for (const auto e : disc) {
        const double own = elements_.areaM2(e);
        if (photons_[e].count == 0 && count / area * own >= kSurelyFull) continue;
        power += photons_[e].power, open += photons_[e].count > 0 ? double{openM2_[e]} : own;
    }
    return power / static_cast<float>(open);
}

}  // namespace luxdeck
