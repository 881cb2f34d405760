#pragma once

#include "engine/core/result.h"
#include "engine/transport/photon_map/photon_tracer.h"
#include "engine/transport/radiance_estimator.h"
#include "engine/transport/surface/surface_elements.h"
#include "engine/transport/tracer/irradiance_field.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace luxdeck {

/// Light on the matte surfaces by photons: their density about each of many small elements.
class PhotonField final : public IrradianceField {
public:
    /// settings  effort: photons grow with it; seed, progress, maxVertices
    /// errors    Cancelled; InvalidArgument: effort out of range
    static Result<std::unique_ptr<PhotonField>> create(const TransportScene& scene, const AlgorithmSettings& settings);

    void indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const override;

    [[nodiscard]] bool hasGaps() const override { return !gaps_.empty(); }
    void gaps(std::span<const FieldPoint> points, std::span<Rgb> lux) const override;

    /// paths: photons emitted; rejected, truncated: of them.
    [[nodiscard]] const TransportCounters& counters() const { return counters_; }
    [[nodiscard]] const SurfaceElements& elements() const { return elements_; }
    /// Indirect light of an element [lx].
    [[nodiscard]] const Rgb& lux(std::size_t element) const { return lux_[element]; }
    [[nodiscard]] std::size_t bytes() const { return elements_.bytes() + (lux_.size() + gaps_.size()) * sizeof(Rgb); }

private:
    explicit PhotonField(SurfaceElements elements) : elements_(std::move(elements)) {}

    void look(std::span<const FieldPoint> points, std::span<const Rgb> of, std::span<Rgb> lux) const;

    SurfaceElements elements_;
    std::vector<Rgb> lux_;   // by element
    std::vector<Rgb> gaps_;  // by element: the most that lux_ may lack; empty: nothing
    TransportCounters counters_;
};

}  // namespace luxdeck
