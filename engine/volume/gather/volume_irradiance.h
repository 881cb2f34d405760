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
    [[nodiscard]] std::size_t bytes() const { return volume_.bytes() + field_->bytes(); }

private:
    VolumeIrradiance(IrradianceVolume volume, const Raycaster& raycaster, std::unique_ptr<const RadianceEstimator> paths)
        : volume_(std::move(volume)), raycaster_(raycaster), paths_(std::move(paths)) {}
    [[nodiscard]] Rgb byPath(const FieldPoint& point) const;

    IrradianceVolume volume_;
    std::unique_ptr<VolumeField> field_;
    const Raycaster& raycaster_;
    std::unique_ptr<const RadianceEstimator> paths_;
};

}  // namespace luxdeck
