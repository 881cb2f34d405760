#include "analysis/compare/volume_pairs.h"

#include "engine/core/rng.h"
#include "engine/core/stopwatch.h"
#include "engine/volume/volume_build.h"
#include "engine/volume/volume_diff.h"
#include "engine/volume/volume_file.h"

#include <memory>
#include <string>
#include <system_error>
#include <utility>

namespace luxdeck {

namespace {

constexpr int kSide = 9;  // 162 bins: differences between algorithms are smooth

struct Built {
    std::shared_ptr<const IrradianceVolume> volume;
    double setupSeconds = 0;
};

/// A volume by one algorithm; samples independent of those of others.
Result<Built> buildBy(const std::string& algorithm, const LitScene& lit, const AlgorithmSettings& base, std::uint64_t seed, VolumeSettings settings,
                      std::uint32_t samples, const Progress& progress) {
    const Stopwatch clock;
    const auto estimator = makeEstimator(algorithm, lit.transport(), base, seed, progress);
    if (!estimator) return estimator.error();
    const double setup = clock.seconds();
    settings.samplesPerBin = samples, settings.side = kSide;
    BuildOptions options;
    options.algorithm = algorithm, options.seed = seed;
    auto volume = buildVolume(lit.transport(), **estimator, settings, options, progress);
    if (!volume) return volume.error();
    return Built{std::make_shared<const IrradianceVolume>(*std::move(volume)), setup};
}

Result<void> compareParts(const IrradianceVolume& reference, const Built& built, Comparison& comparison) {
    const auto differences = compareVolumes(reference, *built.volume);
    if (!differences) return differences.error();
    for (const auto& [name, d] : {std::pair{"total", &differences->total}, {"direct", &differences->direct}, {"indirect", &differences->indirect}})
        comparison.volumes.push_back({built.volume->algorithm, name, built.setupSeconds + built.volume->seconds, d->rms, d->p99, d->max, d->noise, d->meanSecond, d->meanFirst});
    return {};
}

}  // namespace

Result<void> compareVolumePairs(const Project& project, const LitScene& lit, const AlgorithmSettings& settings, const TakeVolume& take,
                                const Progress& progress, Comparison& comparison) {
    const auto volumeSettings = volumeSettingsOf(project, "");
    if (!volumeSettings) return volumeSettings.error();
    // Another seed than the algorithms': `path` is not compared with itself.
    const auto reference = buildBy("path", lit, settings, streamSeed(comparison.seed, 1), *volumeSettings, kPairReferenceSamples, progress);
    if (!reference) return reference.error();
    comparison.complete = comparison.complete && reference->volume->complete;
    if (!comparison.complete) return {};
    if (const auto taken = take("reference", reference->volume); !taken) return taken;
    for (const auto& algorithm : comparison.algorithms) {
        if (!algorithm.refused.empty()) continue;
        const auto built = buildBy(algorithm.name, lit, settings, comparison.seed, *volumeSettings, kPairSamples, progress);
        if (!built && built.error().code != ErrorCode::Cancelled) return built.error();
        comparison.complete = built && built->volume->complete;
        if (!comparison.complete) return {};
        if (const auto done = compareParts(*reference->volume, *built, comparison); !done) return done;
        if (const auto taken = take(algorithm.name, built->volume); !taken) return taken;
    }
    return {};
}

Result<void> compareVolumePairs(const Project& project, const LitScene& lit, const AlgorithmSettings& settings, const std::filesystem::path& folder,
                                const Progress& progress, Comparison& comparison) {
    std::error_code ec;
    std::filesystem::create_directories(folder, ec);
    if (ec) return Error{ErrorCode::InvalidArgument, "cannot be made: " + ec.message(), folder.string()};
    std::shared_ptr<const IrradianceVolume> reference;
    const auto write = [&](const std::string& name, const std::shared_ptr<const IrradianceVolume>& volume) -> Result<void> {
        if (auto written = writeVolume(folder / (name + ".vtu"), *volume); !written) return written;
        if (!reference) {
            reference = volume;
            return {};
        }
        const auto difference = volumeDifference(*volume, *reference);
        return difference ? writeVolume(folder / (name + "_difference.vtu"), *difference) : difference.error();
    };
    return compareVolumePairs(project, lit, settings, TakeVolume(write), progress, comparison);
}

}  // namespace luxdeck
