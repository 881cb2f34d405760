#include "engine/volume/gather/volume_irradiance.h"

#include "engine/volume/vertex_sampler.h"
#include "engine/volume/visible_lookup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace luxdeck {

Result<std::unique_ptr<VolumeIrradiance>> VolumeIrradiance::create(IrradianceVolume volume, const Raycaster& raycaster,
                                                                   std::unique_ptr<const RadianceEstimator> paths) {
    std::unique_ptr<VolumeIrradiance> out(new VolumeIrradiance(std::move(volume), raycaster, std::move(paths)));
    FieldSettings settings;
    settings.part = LightPart::Indirect, settings.blendBins = true;
    auto field = VolumeField::make(out->volume_, settings);
    if (!field) return field.error();
    out->field_ = std::make_unique<VolumeField>(*std::move(field));
    return out;
}

/// Without bias: a dark corner behind all vertices is dark, a lit one is lit on average.
SensorSample VolumeIrradiance::sampleAt(const FieldPoint& point) const {
    SensorQuery query;
    query.position = point.position, query.normal = point.normal;
    query.numbers = SamplePath(placeHash(point.position), 0);
    SensorSample sample;
    (void)paths_->irradiance({&query, 1}, {&sample, 1});
    return sample;
}

void VolumeIrradiance::indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const {
    std::vector<Vec3> positions, normals;
    for (const auto& p : points) positions.push_back(p.position), normals.push_back(p.normal);
    // Points come already lifted off their surfaces.
    VisibleLookup(*field_, raycaster_).at(positions, normals, {}, lux);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!isFinite(lux[i])) {
            const auto sample = sampleAt(points[i]);
            // Nobody asks for gaps that the volume does not know of.
            lux[i] = hasGaps() || sample.lost.isBlack() ? sample.indirect : Rgb(std::numeric_limits<float>::quiet_NaN());
        }
}

void VolumeIrradiance::gaps(std::span<const FieldPoint> points, std::span<Rgb> lux) const {
    if (!lost_) return IrradianceField::gaps(points, lux);
    if (unbounded_) std::ranges::fill(lux, Rgb(kInfinity));
    else lost_->indirect(points, lux);
}

void VolumeIrradiance::setLost(std::unique_ptr<const VolumeIrradiance> lost) {
    lost_ = std::move(lost);
    unbounded_ = !std::ranges::all_of(lost_->volume_.indirect, [](const Rgb& c) { return isFinite(c); });
}

bool VolumeIrradiance::lacksLight() const {
    return std::ranges::any_of(volume_.quality, [](const auto& q) { return q.rejected > 0; });
}

}  // namespace luxdeck
