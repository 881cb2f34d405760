#include "analysis/compare/keep_reference.h"

#include "engine/core/file.h"

#include <fmt/format.h>

namespace luxdeck {

Result<void> ReferenceKeeper::open(std::vector<std::string>& warnings) {
    kept_ = {project_.scene.hash, project_.fileHash, {}};
    std::error_code ec;
    if (settings_.referenceFile.empty() || !std::filesystem::exists(settings_.referenceFile, ec)) return {};
    const auto where = settings_.referenceFile.string();
    const auto bytes = readFile(settings_.referenceFile);
    if (!bytes) return bytes.error();
    auto file = readReferenceJson(*bytes, where);
    if (!file) return file.error();
    if (file->sceneHash == kept_.sceneHash && file->projectHash == kept_.projectHash) {
        kept_ = *std::move(file);
        return {};
    }
    if (!settings_.renewReference)
        return Error{ErrorCode::InvalidArgument, fmt::format("is the reference of another project (scene {}, project {}), expected scene {}, project {}: name another file", file->sceneHash,
                                                             file->projectHash, kept_.sceneHash, kept_.projectHash), where};
    warnings.push_back(fmt::format("{} was of another project: measured anew", where));
    return {};
}

Result<Reference> ReferenceKeeper::get(const Subject& subject, const LitScene& lit, const Progress& progress) {
    const auto found = kept_.references.find(subject.key());
    if (found != kept_.references.end() && found->second.algorithm == settings_.referenceAlgorithm &&
        found->second.parts.front().size() == subject.size() && relativeError95(found->second.fields(subject)) <= asked(subject))
        return found->second;
    ReferenceSettings settings;
    settings.algorithm = settings_.referenceAlgorithm;
    settings.algorithmSettings = settings_.algorithmSettings;
    settings.seed = settings_.seed;
    settings.error = asked(subject);
    auto measured = measureReference(subject, lit, settings, progress);
    if (!measured) return measured.error();
    kept_.references[subject.key()] = *measured;
    changed_ = true;
    return measured;
}

Result<void> ReferenceKeeper::close() const {
    if (settings_.referenceFile.empty() || !changed_) return {};
    return writeFileAtomically(settings_.referenceFile, referenceJson(kept_));
}

ComparedReference ReferenceKeeper::describe(const Subject& subject, const Reference& reference, double relativeError) const {
    ComparedReference out{subject.name(), subject.isPicture(), 0, 0, subject.size(), reference.algorithm, relativeError, asked(subject), reference.samples, reference.seconds, reference.reused};
    if (subject.isPicture()) {
        const auto last = subject.placeOf(subject.size() - 1);
        out.width = last.column + 1, out.height = last.row + 1;
    }
    return out;
}

}  // namespace luxdeck
