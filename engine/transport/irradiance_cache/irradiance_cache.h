#pragma once

#include "engine/core/result.h"
#include "engine/transport/irradiance_cache/record.h"
#include "engine/transport/irradiance_cache/record_grid.h"
#include "engine/transport/radiance_estimator.h"
#include "engine/transport/tracer/irradiance_field.h"
#include "engine/transport/tracer/path_batch.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace luxdeck {

/// Indirect irradiance on matte surfaces, interpolated between records (Ward, Rubinstein & Clear 1988; gradients of Ward &
/// Heckbert 1992). A record is used where Ward's error estimate is within the accuracy and nothing stands between it and
/// the point. A point without any asks a coarser cache, and without such one path instead: noisy, never biased, and the same
/// each time it is asked.
class IrradianceCache final : public IrradianceField {
public:
    /// settings  of paths that are followed where no record serves; without a field
    /// coarser   may be none
    IrradianceCache(const TransportScene& scene, const TracerSettings& settings, std::vector<IrradianceRecord> records, CacheAccuracy accuracy,
                    std::unique_ptr<const IrradianceCache> coarser = nullptr);

    void indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const override;
    [[nodiscard]] bool hasGaps() const override { return hasGaps_; }
    void gaps(std::span<const FieldPoint> points, std::span<Rgb> lux) const override;

    [[nodiscard]] std::size_t bytes() const { return records_.capacity() * sizeof(IrradianceRecord) + grid_.bytes() + (coarser_ ? coarser_->bytes() : 0); }
    [[nodiscard]] std::span<const IrradianceRecord> records() const { return records_; }
    /// None, or the one that is asked where no record serves.
    [[nodiscard]] const IrradianceCache* coarser() const { return coarser_.get(); }
    [[nodiscard]] const CacheAccuracy& accuracy() const { return accuracy_; }

    /// What was asked so far, by all threads.
    struct Usage {
        std::uint64_t asked = 0;
        std::uint64_t unserved = 0; // by no record: the coarser cache was asked, or a path
        std::uint64_t clamped = 0;  // a record's extrapolation was below zero in a channel, and was set to it
    };
    [[nodiscard]] Usage usage() const { return {asked_, unserved_, clamped_}; }

private:
    struct Pending;
    struct Sum;
    enum class Part : std::uint8_t { Light, Gap };
    void look(std::span<const FieldPoint> points, std::span<Rgb> lux, Part part) const;
    void takeRecords(std::uint32_t index, const FieldPoint& point, Sum& sum, std::vector<Pending>& pending, std::vector<Ray>& rays, std::uint64_t& clamped) const;
    void takeSeen(std::span<const FieldPoint> points, std::span<const Pending> pending, std::span<const Ray> rays, std::span<Sum> sums, std::uint64_t& clamped) const;
    void askOthers(std::span<const FieldPoint> points, std::span<const std::uint32_t> which, std::span<Rgb> lux, Part part) const;
    void askPaths(std::span<const FieldPoint> points, std::span<Rgb> lux, Part part) const;

    TransportScene scene_;
    TracerSettings settings_;
    std::vector<IrradianceRecord> records_;
    CacheAccuracy accuracy_;
    RecordGrid grid_;
    bool hasGaps_ = false;
    std::unique_ptr<const IrradianceCache> coarser_;
    mutable std::atomic<std::uint64_t> asked_{0}, unserved_{0}, clamped_{0};
};

/// Fills a cache over the surfaces of a scene. The same bits at any number of threads.
///
/// settings  effort, seed, progress, maxVertices
/// errors    InvalidArgument: a setting out of range; Cancelled
Result<std::unique_ptr<IrradianceCache>> makeIrradianceCache(const TransportScene& scene, const AlgorithmSettings& settings);

}  // namespace luxdeck
