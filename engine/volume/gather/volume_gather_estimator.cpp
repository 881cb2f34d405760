#include "engine/volume/gather/volume_gather_estimator.h"

#include "engine/transport/path/path_estimator.h"
#include "engine/transport/sensor/field_gather.h"
#include "engine/volume/gather/lost_light.h"
#include "engine/volume/gather/volume_irradiance.h"
#include "engine/volume/volume_build.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck {

namespace {

/// A scene without anything that reflects has no indirect light.
class Dark final : public IrradianceField {
public:
    void indirect(std::span<const FieldPoint>, std::span<Rgb> lux) const override { std::fill(lux.begin(), lux.end(), Rgb{}); }
};

/// Effort goes into samples and vertices alike: the error of either is worth nothing without the other's.
VolumeSettings settingsFor(double effort) {
    VolumeSettings s;
    const int across = std::clamp(static_cast<int>(std::lround(5 * std::pow(effort, 0.2))), 2, 64);
    s.firstLevel = {across, across, across};
    s.side = 7;
    s.samplesPerBin = static_cast<std::uint32_t>(std::clamp(std::lround(4 * std::pow(effort, 0.4)), 1L, 1L << 16));
    s.lightSamples = 1;  // of direct light the field is not asked
    return s;
}

/// lost  instead of the light, the most that is missing of it
Result<std::unique_ptr<VolumeIrradiance>> makeField(const TransportScene& scene, const AlgorithmSettings& settings, bool lost) {
    auto path = makePathEstimator(scene, settings);
    if (!path) return path.error();
    std::unique_ptr<const RadianceEstimator> paths = *std::move(path);
    auto asked = settingsFor(settings.effort);
    if (lost) {  // sources that are sought are not lost
        paths = std::make_unique<LostLight>(std::move(paths));
        asked.sources = SourceSampling::InBins;
    }
    BuildOptions options;
    options.seed = settings.seed;
    const Progress silent;
    const auto& progress = settings.progress != nullptr ? *settings.progress : silent;
    auto volume = buildVolume(scene, *paths, asked, options, progress);
    if (!volume) return volume.error();
    if (!volume->complete) return Error{ErrorCode::Cancelled, "interrupted while the volume was built"};
    return VolumeIrradiance::create(*std::move(volume), scene.raycaster, std::move(paths));
}

}  // namespace

Result<std::unique_ptr<RadianceEstimator>> makeVolumeGatherEstimator(const TransportScene& scene, const AlgorithmSettings& settings) {
    if (scene.scene.triangleCount() == 0) return makeFieldGather(scene, settings, std::make_unique<Dark>(), 0);
    auto field = makeField(scene, settings, false);
    if (!field) return field.error();
    if ((*field)->lacksLight()) {
        auto lost = makeField(scene, settings, true);
        if (!lost) return lost.error();
        (*field)->setLost(*std::move(lost));
    }
    const std::size_t bytes = (*field)->bytes();
    return makeFieldGather(scene, settings, *std::move(field), bytes);
}

}  // namespace luxdeck
