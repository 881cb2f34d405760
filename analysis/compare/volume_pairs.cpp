#include "analysis/compare/volume_pairs.h"

#include "engine/volume/volume_build.h"
#include "engine/volume/volume_file.h"

#include <chrono>
#include <system_error>
#include <utility>

namespace luxdeck {

namespace {

constexpr int kSide = 9;  // 162 bins: differences between algorithms are smooth

double since(std::chrono::steady_clock::time_point begun) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(); }

struct Built {
    IrradianceVolume volume;
    double setupSeconds = 0;
};

/// A volume by one algorithm; samples independent of those of others.
Result<Built> buildBy(const std::string& algorithm, const LitScene& lit, const AlgorithmSettings& base, std::uint64_t seed, VolumeSettings settings,
                      std::uint32_t samples, const Progress& progress) {
    auto own = base;
    own.seed = seed, own.progress = &progress;
    const auto begun = std::chrono::steady_clock::now();
    const auto estimator = makeEstimator(algorithm, lit.transport(), own);
    if (!estimator) return estimator.error();
    const double setup = since(begun);
    settings.samplesPerBin = samples, settings.side = kSide;
    BuildOptions options;
    options.algorithm = algorithm, options.seed = seed;
    auto volume = buildVolume(lit.transport(), **estimator, settings, options, progress);
    if (!volume) return volume.error();
    return Built{*std::move(volume), setup};
}

Result<VolumePair> pairOf(const IrradianceVolume& reference, const Built& built, const std::filesystem::path& folder) {
    VolumePair pair;
    pair.algorithm = built.volume.algorithm, pair.setupSeconds = built.setupSeconds, pair.seconds = built.volume.seconds;
    for (const auto& [part, out] : {std::pair{LightPart::Total, &pair.total}, {LightPart::Direct, &pair.direct}, {LightPart::Indirect, &pair.indirect}}) {
        FieldSettings settings;
        settings.part = part;
        const auto difference = compareVolumes(reference, built.volume, settings);
        if (!difference) return difference.error();
        *out = *difference;
    }
    const auto difference = volumeDifference(built.volume, reference);
    if (!difference) return difference.error();
    if (const auto written = writeVolume(folder / (pair.algorithm + ".vtu"), built.volume); !written) return written.error();
    if (const auto written = writeVolume(folder / (pair.algorithm + "_difference.vtu"), *difference); !written) return written.error();
    return pair;
}

}  // namespace

Result<VolumePairs> compareVolumePairs(const Project& project, const LitScene& lit, const std::vector<std::string>& algorithms,
                                       const AlgorithmSettings& settings, std::uint64_t seed, const std::filesystem::path& folder, const Progress& progress) {
    const auto volumeSettings = volumeSettingsOf(project, "");
    if (!volumeSettings) return volumeSettings.error();
    std::error_code ec;
    std::filesystem::create_directories(folder, ec);
    if (ec) return Error{ErrorCode::InvalidArgument, "cannot be made: " + ec.message(), folder.string()};
    VolumePairs out;
    out.referenceAlgorithm = "path";
    const auto reference = buildBy(out.referenceAlgorithm, lit, settings, seed ^ 0x5eed, *volumeSettings, kPairReferenceSamples, progress);
    if (!reference) return reference.error();
    out.referenceSeconds = reference->volume.seconds, out.referenceError95 = 1.96 * reference->volume.relativeError();
    if (const auto written = writeVolume(folder / "reference.vtu", reference->volume); !written) return written.error();
    out.complete = reference->volume.complete;
    for (const auto& algorithm : algorithms) {
        if (!out.complete) break;
        const auto built = buildBy(algorithm, lit, settings, seed, *volumeSettings, kPairSamples, progress);
        if (!built && built.error().code != ErrorCode::Cancelled) return built.error();
        out.complete = built && built->volume.complete;
        if (!out.complete) break;
        auto pair = pairOf(reference->volume, *built, folder);
        if (!pair) return pair.error();
        out.pairs.push_back(*std::move(pair));
    }
    return out;
}

}  // namespace luxdeck
