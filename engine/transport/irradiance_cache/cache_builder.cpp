#include "engine/transport/irradiance_cache/cache_builder.h"

#include "engine/core/parallel.h"
#include "engine/transport/enclosure.h"
#include "engine/transport/irradiance_cache/reflected_light.h"
#include "engine/transport/irradiance_cache/sight.h"
#include "engine/transport/sensor/illuminance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

namespace luxdeck {

namespace {

/// Of the coarse cache. Its error is seen after one more reflection only, spread over a hemisphere.
constexpr float kCoarse = 0.4F;
/// The search begins with records this far apart, and goes on in these steps.
constexpr float kWidest = 1.4F;
constexpr float kStep = 0.7F;
/// A record is placed where the next is further away than this part of its reach: wherever one looks some overlap.
constexpr float kSpacing = 0.7F;
/// A round of random points among which fewer than this part lack a record ends the search.
constexpr double kFewLacking = 0.02;
constexpr std::uint32_t kFirstRound = 64, kLargestRound = 8192;
/// Random points tried for each record that may be placed.
constexpr std::size_t kTries = 32;
/// Paths that find out whether any light comes to a point.
constexpr std::uint32_t kLitPaths = 4;
constexpr int kLitReflections = 8;
constexpr double kLeastCoarseRays = 16;
constexpr double kRaysPerReflection = 3;  // roughly: the path's own, to a light, about panes
/// Neighbours face the same way by this cosine; what clamps their distances by less is let be, so that it ends soon.
constexpr float kSameWay = 0.5F;
constexpr float kClampStep = 0.01F;
/// Bounds of the mean distance: the finest, of that of a typical point.
constexpr float kFinest = 0.3F;

enum Purpose : std::uint64_t { kForPoints = 1, kForSurroundings, kForLit, kForRecords };

}  // namespace

CachePlan CachePlan::of(double effort) {
    CachePlan plan;
    const double root = std::sqrt(effort);
    plan.accuracy = static_cast<float>(std::min(double{kCoarse}, 0.2 / std::sqrt(root)));
    plan.mostRecords = static_cast<std::size_t>(std::ceil(5000 * root));
    plan.hemisphere = HemisphereCells::about(192 * root);
    plan.coarsePaths = 80000 * effort;
    plan.mostRays = 6e6 * effort;
    return plan;
}

CacheBuilder::CacheBuilder(const TransportScene& scene, const AlgorithmSettings& settings)
    : scene_(scene), plan_(CachePlan::of(settings.effort)), seed_(settings.seed), progress_(settings.progress),
      points_(scene, streamSeed(settings.seed, 0, kForPoints)) {
    tracer_.maxVertices = settings.maxVertices;
    const auto box = scene.scene.bounds();
    reached_ = kWidest;
    mostDistance_ = box.isEmpty() ? 1.0F : std::max(box.size().length(), 1e-6F);
}

Result<std::unique_ptr<IrradianceCache>> CacheBuilder::build() {
    const auto few = placeDownTo(std::max(kCoarse, plan_.accuracy), plan_.mostRecords / 4);
    gather(nullptr, coarseHemisphere(), few);
    const auto byPaths = finished(few, nullptr);
    report(0.2);
    gather(byPaths.get(), plan_.hemisphere, few);
    std::unique_ptr<const IrradianceCache> coarse = finished(few, nullptr);
    report(0.3);
    const auto all = placeDownTo(plan_.accuracy, plan_.mostRecords);
    report(0.5);
    gather(coarse.get(), plan_.hemisphere, all);
    report(1);
    if (cancelled()) return Error{ErrorCode::Cancelled, "the irradiance cache was not finished"};
    return finished(all, std::move(coarse));
}

/// Places records ever more closely, until they are as close as asked for or used up.
///
/// returns  the accuracy at which nearly every point has a record
CacheAccuracy CacheBuilder::placeDownTo(float accuracy, std::size_t mostRecords) {
    while (reached_ > accuracy) {
        const float next = std::max(accuracy, kStep * reached_);
        if (!place(CacheAccuracy(next), mostRecords)) break;
        reached_ = next;
    }
    return CacheAccuracy(reached_);
}

bool CacheBuilder::place(CacheAccuracy accuracy, std::size_t mostRecords) {
    const bool dark = scene_.lights.empty() && scene_.sky == nullptr;
    if (points_.empty() || dark) return true;
    RecordGrid grid;
    for (std::uint32_t i = 0; i < records_.size(); ++i) grid.insert(i, records_[i].position, accuracy.reach(records_[i]));
    const std::uint32_t last = nextPoint_ + static_cast<std::uint32_t>(std::min<std::size_t>(kTries * mostRecords, 1U << 30));
    for (std::uint32_t size = kFirstRound; nextPoint_ < last; size = std::min(2 * size, kLargestRound)) {
        std::vector<Candidate> candidates(size);
        parallelFor(size, [&](std::size_t i) {
            if (!cancelled()) examine(nextPoint_ + static_cast<std::uint32_t>(i), grid, accuracy, candidates[i]);
        });
        nextPoint_ += size;
        if (cancelled()) return false;
        const auto added = takeRound(candidates, grid, accuracy, mostRecords);
        if (records_.size() >= mostRecords) return false;
        if (size >= 1024 && static_cast<double>(added) < kFewLacking * size) return true;
    }
    return true;
}

void CacheBuilder::examine(std::uint32_t index, const RecordGrid& grid, CacheAccuracy accuracy, Candidate& candidate) const {
    candidate.point = points_.at(index);
    candidate.lacking = !served(candidate.point, grid, accuracy.scaled(kSpacing), true);
    if (!candidate.lacking) return;
    candidate.lit = lit(index, candidate.point);
    if (candidate.lit)
        candidate.around = lookAround(scene_.raycaster, candidate.point.position, candidate.point.geometricNormal, streamSeed(seed_, index, kForSurroundings));
}

/// trace  false: where rays would tell, a record counts as seen
bool CacheBuilder::served(const FieldPoint& point, const RecordGrid& grid, CacheAccuracy accuracy, bool trace) const {
    bool found = false;
    grid.forEachNear(point.position, [&](std::uint32_t r) {
        if (found || !(accuracy.weight(records_[r], point.position, point.normal) > 0)) return;
        SightRays sight;
        const auto seen = sightOf(records_[r], point, sight);
        std::array<std::uint8_t, 2> hidden{};
        const auto count = static_cast<std::size_t>(sight.count);
        if (seen == Sight::Asked && trace) scene_.raycaster.occluded({sight.rays.data(), count}, {hidden.data(), count}, Targets::Opaque);
        found = seen != Sight::Hidden && hidden[0] == 0 && hidden[1] == 0;
    });
    return found;
}

/// The insides of solids are surfaces too, and dark.
bool CacheBuilder::lit(std::uint32_t index, const FieldPoint& point) const {
    std::array<SensorQuery, kLitPaths> queries;
    std::array<SensorSample, kLitPaths> samples;
    for (std::uint32_t i = 0; i < kLitPaths; ++i)
        queries[i] = {point.position, point.normal, SensorKind::Planar, SamplePath(streamSeed(seed_, index, kForLit), i)};
    auto few = tracer_;
    few.maxReflections = kLitReflections;
    gatherIlluminance(scene_, few, queries, samples);
    return std::any_of(samples.begin(), samples.end(), [](const auto& s) { return !(s.total() + s.lost).isBlack(); });
}

std::size_t CacheBuilder::takeRound(std::span<const Candidate> candidates, RecordGrid& grid, CacheAccuracy accuracy, std::size_t mostRecords) {
    if (leastDistance_ == 0) setScale(candidates);
    std::size_t added = 0;
    for (const auto& c : candidates) {
        if (!c.lacking || !c.lit || records_.size() >= mostRecords) continue;
        if (served(c.point, grid, accuracy.scaled(kSpacing), false)) continue;
        add(c, grid, accuracy);
        ++added;
    }
    clampByNeighbours(grid);
    return added;
}

/// What a typical mean distance is, by the first points that were looked at.
void CacheBuilder::setScale(std::span<const Candidate> candidates) {
    std::vector<float> distances;
    for (const auto& c : candidates)
        if (c.lit) distances.push_back(std::min(c.around.meanDistance, mostDistance_));
    if (distances.empty()) return;
    std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2), distances.end());
    leastDistance_ = std::max(kFinest * distances[distances.size() / 2], 1e-6F * mostDistance_);
}

void CacheBuilder::add(const Candidate& c, RecordGrid& grid, CacheAccuracy accuracy) {
    IrradianceRecord record;
    record.position = c.point.position, record.normal = c.point.normal, record.geometricNormal = c.point.geometricNormal;
    record.horizon = c.around.horizon;
    record.distance = std::clamp(c.around.meanDistance, leastDistance_, mostDistance_);
    grid.insert(static_cast<std::uint32_t>(records_.size()), record.position, accuracy.reach(record));
    records_.push_back(record);
}

/// Neighbours' distances differ by no more than the way between them: what one record's rays missed another's met.
/// Source: Krivanek et al. 2006, "Making Radiance and Irradiance Caching Practical: Adaptive Caching and Neighbor Clamping".
void CacheBuilder::clampByNeighbours(const RecordGrid& grid) {
    for (bool changed = true; changed;) {
        changed = false;
        for (auto& record : records_)
            grid.forEachNear(record.position, [&](std::uint32_t r) {
                auto& other = records_[r];
                if (dot(other.normal, record.normal) < kSameWay) return;
                const float apart = (other.position - record.position).length();
                const auto clamp = [&](IrradianceRecord& a, const IrradianceRecord& b) {
                    if (a.distance <= (b.distance + apart) * (1 + kClampStep)) return;
                    a.distance = b.distance + apart;
                    changed = true;
                };
                clamp(record, other), clamp(other, record);
            });
    }
}

/// As many paths for each record as the plan has, or as it can afford where paths are long.
HemisphereCells CacheBuilder::coarseHemisphere() const {
    const double absorbed = 1 - std::min(meanReflectance(scene_.scene), 0.9999);
    const double affordable = std::min(plan_.coarsePaths, plan_.mostRays * absorbed / kRaysPerReflection);
    return HemisphereCells::about(std::max(affordable / std::max(double(records_.size()), 1.0), kLeastCoarseRays));
}

void CacheBuilder::gather(const IrradianceField* field, const HemisphereCells& hemisphere, CacheAccuracy accuracy) {
    auto tracer = tracer_;
    tracer.field = field;
    done_.assign(records_.size(), 0);
    parallelFor(records_.size(), [&](std::size_t i) {
        if (!cancelled()) gatherRecord(i, tracer, hemisphere, accuracy);
    });
}

void CacheBuilder::gatherRecord(std::size_t index, const TracerSettings& tracer, const HemisphereCells& hemisphere, CacheAccuracy accuracy) {
    auto& record = records_[index];
    const auto frame = Frame::about(record.normal);
    ReflectedLight reflected(scene_, tracer);
    FieldPoint point;
    point.position = record.position, point.normal = record.normal, point.geometricNormal = record.geometricNormal;
    reflected.stand(point);
    const std::uint64_t stream = streamSeed(seed_, index, kForRecords + (tracer.field != nullptr ? 1 : 0));
    for (int i = 0; i < hemisphere.count(); ++i) {
        SamplePath numbers(stream, static_cast<std::uint32_t>(i));
        const Vec2 within = numbers.next2D();
        reflected.ask(frame.toWorld(hemisphere.direction(i, within)), numbers);
    }
    const auto answers = reflected.trace();

    std::vector<HemisphereCell> cells(answers.size());
    Rgb lost, mirrored;
    ColourGradient mirroredRotation;
    const auto count = static_cast<float>(answers.size());
    for (std::size_t i = 0; i < answers.size(); ++i) {
        cells[i] = {answers[i].radiance, answers[i].distance};
        lost += answers[i].lost * (kPi / count);
        if (answers[i].mirrored.isBlack()) continue;
        mirrored += answers[i].mirrored / count;
        const Vec3 from = frame.toLocal(answers[i].mirroredFrom);
        mirroredRotation.add(Vec3(from.x, from.y, 0) / (from.z * count), answers[i].mirrored);
    }
    record.gap = lost;
    auto found = irradianceAndGradients(hemisphere, cells, accuracy.reach(record));
    found.rotation += mirroredRotation;
    record.irradiance = found.irradiance + mirrored;
    record.rotation = found.rotation.toWorld(frame);
    record.translation = found.translation.toWorld(frame);
    record.limitGradients(accuracy);
    done_[index] = 1;
}

std::unique_ptr<IrradianceCache> CacheBuilder::finished(CacheAccuracy accuracy, std::unique_ptr<const IrradianceCache> coarser) const {
    std::vector<IrradianceRecord> records;
    for (std::size_t i = 0; i < records_.size(); ++i)
        if (done_[i] != 0) records.push_back(records_[i]);
    return std::make_unique<IrradianceCache>(scene_, tracer_, std::move(records), accuracy, std::move(coarser));
}

void CacheBuilder::report(double fraction) const {
    if (progress_ == nullptr) return;
    ProgressState state;
    state.stage = "irradiance cache";
    state.fraction = fraction;
    progress_->report(state);
}

}  // namespace luxdeck
