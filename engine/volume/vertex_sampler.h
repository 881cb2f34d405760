#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/volume/volume.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace luxdeck {

/// A stream of random numbers for each place, whatever its number in a lattice.
std::uint64_t placeHash(const Vec3& position);

/// Adds light from one direction to the irradiances of surfaces that face +x -x +y -y +z -z.
inline void addToAxes(std::array<double, 6>& lux, const Vec3& direction, double y) {
    for (int axis = 0; axis < 3; ++axis) lux[static_cast<std::size_t>(2 * axis + (direction[axis] < 0 ? 1 : 0))] += std::abs(double{direction[axis]}) * y;
}

/// All that is known of one vertex.
struct VertexState {
    std::vector<Rgb> direct, indirect;  // #B, means over the samples [cd/m^2]
    std::vector<SourceRay> sources;     // means over the samples
    VertexQuality quality;
};

/// What a volume holds of a vertex; empty where it has no samples.
VertexState stateOf(const IrradianceVolume& volume, std::size_t vertex);

/// Looks around from the vertices of a volume. Immutable; safe to call from any number of threads.
class VertexSampler {
public:
    /// All must outlive it.
    ///
    /// errors  InvalidArgument: settings out of range or that do not go together, no such object to be ignored
    static Result<VertexSampler> create(const TransportScene& scene, const RadianceEstimator& estimator, const VolumeSettings& settings,
                                        std::uint64_t seed);

    /// Samples from the state's own number on up to `samples` of every bin are added to it. The result depends on position,
    /// seed and numbers alone: the same vertex looks the same in any lattice.
    void sample(const Vec3& position, std::uint32_t samples, VertexState& state, TransportCounters& counters) const;

private:
    /// What one sample of every bin found.
    struct Round {
        std::vector<RadianceQuery> queries;
        std::vector<RadianceSample> samples;
        std::vector<SourceRay> sources;
    };

    VertexSampler(const TransportScene& scene, const RadianceEstimator& estimator, const VolumeSettings& settings, std::uint64_t seed);

    void aim(const Vec3& position, std::uint64_t stream, std::uint32_t index, Round& round) const;
    void seekSources(const Receiver& at, std::uint64_t stream, std::uint32_t index, Round& round, TransportCounters& counters) const;
    void seekByMirrors(const Receiver& at, std::uint64_t stream, std::uint32_t index, Round& round, TransportCounters& counters) const;
    [[nodiscard]] bool isInside(const Vec3& position, const VertexQuality& quality, TransportCounters& counters) const;
    void dim(SourceRay& source, const Rgb& passed, Round& round) const;
    void ignore(RadianceSample& sample) const;
    void enter(const Round& round, VertexState& state) const;
    [[nodiscard]] std::array<float, 6> axisLux(const Round& round) const;
    [[nodiscard]] std::array<float, 6> lostLux(const Round& round) const;

    TransportScene scene_;
    const RadianceEstimator* estimator_;
    VolumeSettings settings_;
    DirectionBins bins_;
    std::vector<Vec3> centres_;           // of the bins
    std::vector<std::uint8_t> ignored_;   // by object; empty: none
    std::uint64_t seed_;
};

}  // namespace luxdeck
