#pragma once

#include "engine/transport/radiance_estimator.h"
#include "engine/transport/tracer/irradiance_field.h"
#include "engine/volume/field.h"
#include "engine/volume/volume.h"

#include <memory>

namespace luxdeck {

/// The indirect light of surfaces as an irradiance volume has it: interpolated from vertices that see the surface, along
/// its normal. Where none sees it, one path is asked, whose numbers follow from the place.
class VolumeIrradiance final : public IrradianceField {
public:
    /// raycaster  of the volume's scene; must outlive it
    /// paths      where the volume knows nothing
    /// errors     OutOfResources
    static Result<std::unique_ptr<VolumeIrradiance>> create(IrradianceVolume volume, const Raycaster& raycaster,
                                                            std::unique_ptr<const RadianceEstimator> paths);

    void indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const override;
    [[nodiscard]] bool hasGaps() const override { return lost_ != nullptr; }
    void gaps(std::span<const FieldPoint> points, std::span<Rgb> lux) const override;
    /// Samples of its vertices were such that a part is missing.
    [[nodiscard]] bool lacksLight() const;
    /// Another volume, of what this one may lack.
    void setLost(std::unique_ptr<const VolumeIrradiance> lost);
    [[nodiscard]] std::size_t bytes() const { return volume_.bytes() + field_->bytes() + (lost_ ? lost_->bytes() : 0); }

private:
    VolumeIrradiance(IrradianceVolume volume, const Raycaster& raycaster, std::unique_ptr<const RadianceEstimator> paths)
        : volume_(std::move(volume)), raycaster_(raycaster), paths_(std::move(paths)) {}
    [[nodiscard]] SensorSample sampleAt(const FieldPoint& point) const;

    IrradianceVolume volume_;
    std::unique_ptr<VolumeField> field_;
    const Raycaster& raycaster_;
    std::unique_ptr<const RadianceEstimator> paths_;
    std::unique_ptr<const VolumeIrradiance> lost_;
    bool unbounded_ = false;  // nothing is known of what is missing
};

}  // namespace luxdeck
