#include "analysis/compare/volume_pairs.h"

#include "engine/core/rng.h"
#include "engine/core/stopwatch.h"
#include "engine/volume/volume_build.h"
#include "engine/volume/volume_diff.h"
#include "engine/volume/volume_file.h"

#include <string>
#include <system_error>
#include <utility>

namespace luxdeck {

namespace {

constexpr int kSide = 9;  // 162 bins: differences between algorithms are smooth

struct Built {
    IrradianceVolume volume;
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
    return Built{*std::move(volume), setup};
}

Result<void> compareParts(const IrradianceVolume& reference, const Built& built, Comparison& comparison) {
    const auto differences = compareVolumes(reference, built.volume);
    if (!differences) return differences.error();
    for (const auto& [name, d] : {std::pair{"total", &differences->total}, {"direct", &differences->direct}, {"indirect", &differences->indirect}})
        comparison.volumes.push_back({built.volume.algorithm, name, built.setupSeconds + built.volume.seconds, d->rms, d->p99, d->max, d->noise, d->meanSecond, d->meanFirst});
    return {};
}

Result<void> writePair(const IrradianceVolume& reference, const IrradianceVolume& volume, const std::filesystem::path& folder) {
    const auto difference = volumeDifference(volume, reference);
    if (!difference) return difference.error();
    if (const auto written = writeVolume(folder / (volume.algorithm + ".vtu"), volume); !written) return written;
    return writeVolume(folder / (volume.algorithm + "_difference.vtu"), *difference);
}

}  // namespace

Result<void> compareVolumePairs(const Project& project, const LitScene& lit, const AlgorithmSettings& settings, const std::filesystem::path& folder,
                                const Progress& progress, Comparison& comparison) {
    const auto volumeSettings = volumeSettingsOf(project, "");
    if (!volumeSettings) return volumeSettings.error();
    std::error_code ec;
    std::filesystem::create_directories(folder, ec);
    if (ec) return Error{ErrorCode::InvalidArgument, "cannot be made: " + ec.message(), folder.string()};
    // Another seed than the algorithms': `path` is not compared with itself.
    const auto reference = buildBy("path", lit, settings, streamSeed(comparison.seed, 1), *volumeSettings, kPairReferenceSamples, progress);
    if (!reference) return reference.error();
    comparison.complete = comparison.complete && reference->volume.complete;
    if (!comparison.complete) return {};
    if (const auto written = writeVolume(folder / "reference.vtu", reference->volume); !written) return written;
    for (const auto& algorithm : comparison.algorithms) {
        if (!algorithm.refused.empty()) continue;
        const auto built = buildBy(algorithm.name, lit, settings, comparison.seed, *volumeSettings, kPairSamples, progress);
        if (!built && built.error().code != ErrorCode::Cancelled) return built.error();
        comparison.complete = built && built->volume.complete;
        if (!comparison.complete) return {};
        if (const auto done = compareParts(reference->volume, *built, comparison); !done) return done;
        if (const auto done = writePair(reference->volume, built->volume, folder); !done) return done;
    }
    return {};
}

}  // namespace luxdeck
