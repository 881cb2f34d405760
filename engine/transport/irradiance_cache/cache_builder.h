#pragma once

#include "engine/core/progress.h"
#include "engine/transport/irradiance_cache/irradiance_cache.h"
#include "engine/transport/irradiance_cache/surface_points.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace luxdeck {

/// What an effort buys.
struct CachePlan {
    float accuracy = 0.2F;           // of the finished cache
    std::size_t mostRecords = 4000;
    HemisphereCells hemisphere;      // rays of a record
    double coarsePaths = 80000;      // of the coarse cache
    double mostRays = 6e6;           // of these, roughly

    static CachePlan of(double effort);
};

/// Builds a cache in two steps. Records are placed by geometry alone: wherever a point of a surface, from a random sequence of
/// them, has no record that serves it, as long as light comes there at all. A coarse cache whose records follow whole paths
/// knows the level of light without bias; the fine one's records see one reflection and ask the coarse one for the rest, so
/// that each costs a third and is less noisy.
class CacheBuilder {
public:
    CacheBuilder(const TransportScene& scene, const AlgorithmSettings& settings);

    /// errors  Cancelled
    Result<std::unique_ptr<IrradianceCache>> build();

private:
    /// A point that lacks a record, and what stands around it.
    struct Candidate {
        FieldPoint point;
        Surroundings around;
        bool lacking = false;  // no record serves it
        bool lit = false;
    };

    CacheAccuracy placeDownTo(float accuracy, std::size_t mostRecords);
    /// False when the records were used up before.
    bool place(CacheAccuracy accuracy, std::size_t mostRecords);
    void examine(std::uint32_t index, const RecordGrid& grid, CacheAccuracy accuracy, Candidate& candidate) const;
    [[nodiscard]] bool served(const FieldPoint& point, const RecordGrid& grid, CacheAccuracy accuracy, bool trace) const;
    [[nodiscard]] bool lit(std::uint32_t index, const FieldPoint& point) const;
    void setScale(std::span<const Candidate> candidates);
    std::size_t takeRound(std::span<const Candidate> candidates, RecordGrid& grid, CacheAccuracy accuracy, std::size_t mostRecords);
    void add(const Candidate& candidate, RecordGrid& grid, CacheAccuracy accuracy);
    void clampByNeighbours(const RecordGrid& grid);
    void gather(const IrradianceField* field, const HemisphereCells& hemisphere, CacheAccuracy accuracy);
    void gatherRecord(std::size_t index, const TracerSettings& tracer, const HemisphereCells& hemisphere, CacheAccuracy accuracy);
    [[nodiscard]] std::unique_ptr<IrradianceCache> finished(CacheAccuracy accuracy, std::unique_ptr<const IrradianceCache> coarser) const;
    [[nodiscard]] HemisphereCells coarseHemisphere() const;
    [[nodiscard]] bool cancelled() const { return progress_ != nullptr && progress_->cancelled(); }
    void report(double fraction) const;

    TransportScene scene_;
    CachePlan plan_;
    std::uint64_t seed_;
    const Progress* progress_;
    TracerSettings tracer_;
    SurfacePoints points_;
    std::vector<IrradianceRecord> records_;
    std::vector<std::uint8_t> done_;     // by record: it was gathered, not cancelled
    float leastDistance_ = 0;            // records' mean distances are clamped to these [m]
    float mostDistance_ = 0;
    std::uint32_t nextPoint_ = 0;
    float reached_ = 1;                  // accuracy at which nearly every point has a record
};

}  // namespace luxdeck
