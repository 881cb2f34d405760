#include "analysis/compare/reference.h"

#include "engine/algorithms/registry.h"
#include "engine/core/rng.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luxdeck {

namespace {

constexpr std::uint64_t kPurpose = 0x4ef;     // of the random streams: none that a compared run has
constexpr std::uint32_t kFirstSamples = 4;    // of a part and a pixel; grids need more anyway
constexpr double kMostGrowth = 3;             // of a round over all before it
constexpr double kAim = 0.97;                 // of the error asked for: a round more costs more than a little too much

/// Weighted means of the parts as rounds come in.
void addRound(Reference& reference, std::size_t part, const Field& values, double weight) {
    auto& own = reference.parts[part];
    if (own.empty()) own = values;
    else
        for (std::size_t i = 0; i < own.size(); ++i) own[i] += weight * (values[i] - own[i]);
}

std::uint32_t wholeSamples(double wanted, std::uint32_t least) {
    const double count = std::clamp(std::ceil(wanted / least), 1.0, 1e6);
    return static_cast<std::uint32_t>(count) * least;
}

Result<void> checkUnbiased(const std::string& name) {
    const auto* algorithm = algorithmNamed(name);
    if (algorithm == nullptr || (algorithm->bias == 0 && algorithm->interreflection)) return {};  // makeEstimator() tells what is not there
    std::string known;
    for (const auto& a : algorithms())
        if (a.bias == 0 && a.interreflection) known += (known.empty() ? "" : ", ") + a.name;
    return Error{ErrorCode::InvalidArgument, fmt::format("\"{}\" is biased or leaves out interreflection and cannot be the reference, expected one of: {}", name, known)};
}

}  // namespace

ReferenceFields Reference::fields(const Subject& subject) const {
    ReferenceFields out{parts, {}};
    Field mean(subject.size());
    for (std::size_t i = 0; i < mean.size(); ++i)
        for (const auto& part : parts) mean[i] += part[i] / static_cast<double>(parts.size());
    out.scale = subject.scaleOf(mean);
    return out;
}

double relativeError95(const ReferenceFields& fields) { return 1.96 * fields.rmsError(); }

Result<Reference> measureReference(const Subject& subject, const LitScene& lit, const ReferenceSettings& settings, const Progress& progress) {
    if (const auto possible = checkUnbiased(settings.algorithm); !possible) return possible.error();
    auto algorithmSettings = settings.algorithmSettings;
    algorithmSettings.seed = streamSeed(settings.seed, 0, kPurpose);
    algorithmSettings.progress = &progress;
    const auto estimator = makeEstimator(settings.algorithm, lit.transport(), algorithmSettings);
    if (!estimator) return estimator.error();
    Reference out{subject.key(), settings.algorithm, std::vector<Field>(kReferenceParts), 0, 0, false};
    double have = 0;  // samples of each part
    std::string told;
    auto samples = wholeSamples(kFirstSamples, subject.leastSamples());
    for (std::uint64_t round = 1;; ++round) {
        std::vector<Field> values;
        for (std::size_t part = 0; part < kReferenceParts; ++part) {
            const auto stage = fmt::format("reference of {}{}, part {} of {}", subject.name(), told, part + 1, kReferenceParts);
            auto measured = subject.measure(**estimator, samples, streamSeed(settings.seed, round * kReferenceParts + part, kPurpose), stage, progress);
            out.seconds += measured.seconds;
            if (!measured.whole) break;
            values.push_back(std::move(measured.values));
        }
        if (values.size() < kReferenceParts) break;  // cancelled: the rounds before it stand
        have += samples;
        for (std::size_t part = 0; part < kReferenceParts; ++part) addRound(out, part, values[part], samples / have);
        const double error = relativeError95(out.fields(subject));
        out.samples = static_cast<std::uint64_t>(have) * kReferenceParts;
        if (error <= settings.error || progress.cancelled()) break;
        const double ratio = error / (kAim * settings.error);
        samples = wholeSamples(std::min(have * (ratio * ratio - 1), have * kMostGrowth), subject.leastSamples());
        told = fmt::format(" ({:.2g} % so far, {:.2g} % asked)", 100 * error, 100 * settings.error);
    }
    if (have == 0) return Error{ErrorCode::Cancelled, "interrupted before there was a reference", subject.name()};
    for (auto& part : out.parts)
        for (auto& value : part) value = static_cast<float>(value);  // as they are kept: a comparison does not change when they are reused
    return out;
}

}  // namespace luxdeck
