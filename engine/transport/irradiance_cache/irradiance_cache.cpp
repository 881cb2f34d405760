#include "engine/transport/irradiance_cache/irradiance_cache.h"

#include "engine/sampling/warp.h"
#include "engine/transport/irradiance_cache/cache_builder.h"
#include "engine/transport/irradiance_cache/reflected_light.h"
#include "engine/transport/irradiance_cache/sight.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace luxdeck {

namespace {

/// Of a point, for its own random numbers.
std::uint64_t hashOf(const Vec3& p) {
    const auto low = std::uint64_t{std::bit_cast<std::uint32_t>(p.x)} << 32 | std::bit_cast<std::uint32_t>(p.y);
    return streamSeed(low, std::bit_cast<std::uint32_t>(p.z), 0x6361636865);
}

}  // namespace

/// What the records said of one point.
struct IrradianceCache::Sum {
    Part part = Part::Light;
    Rgb weighted;
    float weight = 0;

    void add(const IrradianceRecord& record, const FieldPoint& point, float w, std::uint64_t& clamped) {
        weighted += (part == Part::Gap ? record.gap : record.at(point.position, point.normal, clamped)) * w, weight += w;
    }
};

/// A record that serves a point if its rays are free.
struct IrradianceCache::Pending {
    std::uint32_t point, record;
    float weight;
    int rays;
};

IrradianceCache::IrradianceCache(const TransportScene& scene, const TracerSettings& settings, std::vector<IrradianceRecord> records,
                                 CacheAccuracy accuracy, std::unique_ptr<const IrradianceCache> coarser)
    : scene_(scene), settings_(settings), records_(std::move(records)), accuracy_(accuracy), coarser_(std::move(coarser)) {
    hasGaps_ = coarser_ != nullptr && coarser_->hasGaps();
    for (std::uint32_t i = 0; i < records_.size(); ++i) {
        grid_.insert(i, records_[i].position, accuracy_.reach(records_[i]));
        hasGaps_ = hasGaps_ || !records_[i].gap.isBlack();
    }
}

void IrradianceCache::indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const { look(points, lux, Part::Light); }

void IrradianceCache::gaps(std::span<const FieldPoint> points, std::span<Rgb> lux) const { look(points, lux, Part::Gap); }

void IrradianceCache::look(std::span<const FieldPoint> points, std::span<Rgb> lux, Part part) const {
    std::vector<Sum> sums(points.size(), Sum{part, {}, 0});
    std::vector<Pending> pending;
    std::vector<Ray> rays;
    std::uint64_t clamped = 0;
    for (std::uint32_t i = 0; i < points.size(); ++i) takeRecords(i, points[i], sums[i], pending, rays, clamped);
    takeSeen(points, pending, rays, sums, clamped);
    std::vector<std::uint32_t> unserved;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (sums[i].weight > 0) lux[i] = sums[i].weighted / sums[i].weight;
        else unserved.push_back(i);
    }
    if (!unserved.empty()) askOthers(points, unserved, lux, part);
    if (part == Part::Gap) return;
    asked_.fetch_add(points.size(), std::memory_order_relaxed);
    unserved_.fetch_add(unserved.size(), std::memory_order_relaxed);
    clamped_.fetch_add(clamped, std::memory_order_relaxed);
}

void IrradianceCache::takeRecords(std::uint32_t index, const FieldPoint& point, Sum& sum, std::vector<Pending>& pending, std::vector<Ray>& rays,
                                  std::uint64_t& clamped) const {
    grid_.forEachNear(point.position, [&](std::uint32_t r) {
        const auto& record = records_[r];
        const float weight = accuracy_.weight(record, point.position, point.normal);
        if (!(weight > 0)) return;
        SightRays sightRays;
        const auto sight = sightOf(record, point, sightRays);
        if (sight == Sight::Open) sum.add(record, point, weight, clamped);
        if (sight != Sight::Asked) return;
        pending.push_back({index, r, weight, sightRays.count});
        for (int i = 0; i < sightRays.count; ++i) rays.push_back(sightRays.rays[static_cast<std::size_t>(i)]);
    });
}

void IrradianceCache::takeSeen(std::span<const FieldPoint> points, std::span<const Pending> pending, std::span<const Ray> rays, std::span<Sum> sums,
                               std::uint64_t& clamped) const {
    if (pending.empty()) return;
    std::vector<std::uint8_t> hidden(rays.size());
    scene_.raycaster.occluded(rays, hidden, Targets::Opaque);
    std::size_t ray = 0;
    for (const auto& p : pending) {
        bool open = true;
        for (int i = 0; i < p.rays; ++i) open = hidden[ray++] == 0 && open;
        if (open) sums[p.point].add(records_[p.record], points[p.point], p.weight, clamped);
    }
}

void IrradianceCache::askOthers(std::span<const FieldPoint> points, std::span<const std::uint32_t> which, std::span<Rgb> lux,
                                Part part) const {
    std::vector<FieldPoint> asked;
    for (const auto i : which) asked.push_back(points[i]);
    std::vector<Rgb> answers(asked.size());
    if (coarser_) coarser_->look(asked, answers, part);
    else askPaths(asked, answers, part);
    for (std::size_t i = 0; i < which.size(); ++i) lux[which[i]] = answers[i];
}

void IrradianceCache::askPaths(std::span<const FieldPoint> points, std::span<Rgb> lux, Part part) const {
    ReflectedLight reflected(scene_, settings_);
    for (const auto& point : points) {
        SamplePath numbers(hashOf(point.position), 0);
        reflected.stand(point);
        const Vec3 direction = Frame::about(point.normal).toWorld(cosineHemisphere(numbers.next2D()));
        reflected.ask(direction, numbers);
    }
    const auto answers = reflected.trace();
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const auto& answer = answers[i];
        if (part == Part::Gap) lux[i] = answer.lost * kPi;
        else if (!hasGaps_ && !answer.lost.isBlack()) lux[i] = Rgb(std::numeric_limits<float>::quiet_NaN());  // nobody asks for gaps
        else lux[i] = answer.radiance * kPi + answer.mirrored;
    }
}

Result<std::unique_ptr<IrradianceCache>> makeIrradianceCache(const TransportScene& scene, const AlgorithmSettings& settings) {
    if (settings.maxVertices < 2 || settings.maxVertices > 1'000'000)
        return Error{ErrorCode::InvalidArgument, fmt::format("maxVertices is {}, expected 2 .. 1000000", settings.maxVertices)};
    if (!(settings.effort >= 1e-3 && settings.effort <= 1e3))
        return Error{ErrorCode::InvalidArgument, fmt::format("effort is {}, expected 0.001 .. 1000", settings.effort)};
    return CacheBuilder(scene, settings).build();
}

}  // namespace luxdeck
