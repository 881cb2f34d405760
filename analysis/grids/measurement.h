#pragma once

#include "engine/core/statistics.h"
#include "engine/transport/radiance_estimator.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace luxdeck {

/// Every estimate is the mean of this many independently scrambled sample sets: their spread is its error.
/// 32 sets put Student's t at 2.04 and the error's own error at 13 %.
inline constexpr int kReplicates = 32;

/// Part of a point's samples from which on its numbers are withheld when they failed.
inline constexpr double kMostLost = 0.01;

/// The samples of one point so far. Sums by replicate, in luminance (illuminance) and, over all, in colour.
struct PointSums {
    std::array<double, kReplicates> direct{};
    std::array<double, kReplicates> indirect{};
    std::array<double, 3> rgb{};
    std::vector<double> layers;      // #layers x 2 x R, direct then indirect; empty unless they are asked for
    std::uint32_t perReplicate = 0;  // samples of each replicate
    std::uint64_t backFaces = 0;
    std::uint64_t rejected = 0;      // samples of which a part is missing
    double lost = 0;                 // the most that is missing; infinite: nothing is known of it
    std::uint32_t lostAt = kNothing;   // index into Scene::materials of a surface that has no value
    double diffused = 0;             // sums of ChanceLight
    double foundSquares = 0;
    double peak = 0;                 // its largest

    void add(const PointSums& more);
    /// So much is missing that the numbers say nothing: they are withheld.
    [[nodiscard]] bool withheld() const;
    /// More samples will not tell what was not seen: too many of them fail, or lights behind what bends light are so small
    /// that paths will not meet them.
    [[nodiscard]] bool staysOpen() const;
    /// Half-width that more samples bring down [lx]: not what is missing; infinite before it is clear whether too much is.
    [[nodiscard]] double noise() const;
    /// How much more the mean may be than what was found: what is missing of failed samples, and light that is met by
    /// chance alone and was not met. Infinite where the numbers are withheld.
    [[nodiscard]] double unseen() const;
    /// The second of the two.
    [[nodiscard]] double unmet() const;
    [[nodiscard]] std::uint64_t samples() const { return std::uint64_t{perReplicate} * kReplicates; }
    /// Means of every replicate, #R.
    [[nodiscard]] std::array<double, kReplicates> directMeans() const;
    [[nodiscard]] std::array<double, kReplicates> indirectMeans() const;
    [[nodiscard]] std::array<double, kReplicates> totalMeans() const;
    /// Of the mean of such replicates, with what was not seen.
    [[nodiscard]] Interval interval(const std::array<double, kReplicates>& means) const;
    [[nodiscard]] Interval total() const { return interval(totalMeans()); }
    [[nodiscard]] Rgb rgbMean() const;
};

struct LayerMap;

/// Something that is measured at one point by samples: illuminance there, or radiance along a ray.
struct Target {
    bool radiance = false;      // false: illuminance at `sensor`
    SensorQuery sensor;
    Ray ray;
    std::uint32_t grid = 0;     // sensors of one grid may be asked together
    std::uint64_t stream = 0;   // its own random stream: the point's index among all
    const LayerMap* layers = nullptr;  // not null: light is kept apart by layers; of illuminance alone
};

/// Samples first .. first + count - 1 of every replicate of one target. Depends on nothing else, so any
/// thread may take any target.
PointSums measure(const RadianceEstimator& estimator, const LuminanceWeights& weights, const Target& target,
                  std::uint64_t seed, std::uint32_t first, std::uint32_t count, TransportCounters& counters);

/// The same for neighbours that are asked together, sample by sample, each from its own first sample on: members'
/// sums, in their order. Depends on the whole group.
std::vector<PointSums> measureTogether(const RadianceEstimator& estimator, const LuminanceWeights& weights,
                                       std::span<const Target> targets, std::span<const std::size_t> members, std::uint64_t seed,
                                       std::span<const std::uint32_t> firsts, std::uint32_t count, TransportCounters& counters);

}  // namespace luxdeck
