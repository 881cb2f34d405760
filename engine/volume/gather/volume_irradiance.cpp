#include "engine/volume/gather/volume_irradiance.h"

#include "engine/volume/vertex_sampler.h"
#include "engine/volume/visible_lookup.h"

#include <cmath>
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
Rgb VolumeIrradiance::byPath(const FieldPoint& point) const {
    SensorQuery query;
    query.position = point.position, query.normal = point.normal;
    query.numbers = SamplePath(placeHash(point.position), 0);
    SensorSample sample;
    (void)paths_->irradiance({&query, 1}, {&sample, 1});
    return sample.indirect;
}

void VolumeIrradiance::indirect(std::span<const FieldPoint> points, std::span<Rgb> lux) const {
    std::vector<Vec3> positions, normals;
    for (const auto& p : points) positions.push_back(p.position), normals.push_back(p.normal);
    // Points come already lifted off their surfaces.
    VisibleLookup(*field_, raycaster_).at(positions, normals, {}, lux);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!isFinite(lux[i])) lux[i] = byPath(points[i]);
}

}  // namespace luxdeck
