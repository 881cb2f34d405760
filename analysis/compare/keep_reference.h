#pragma once

#include "analysis/compare/compare.h"
#include "analysis/compare/reference.h"

namespace luxdeck {

/// Finds references: in the file that is kept, or by measuring them. Protocol: open(), get() of each subject, close().
class ReferenceKeeper {
public:
    /// both outlive the keeper
    ReferenceKeeper(const Project& project, const CompareSettings& settings) : project_(project), settings_(settings) {}

    /// Reads the file, if there is one. Of another scene: refused, or replaced with a warning, as the settings say.
    Result<void> open(std::vector<std::string>& warnings);
    Result<Reference> get(const Subject& subject, const LitScene& lit, const Progress& progress);
    /// Writes the file when something was measured.
    Result<void> close() const;

    [[nodiscard]] ComparedReference describe(const Subject& subject, const Reference& reference, double relativeError) const;

private:
    [[nodiscard]] double asked(const Subject& subject) const { return subject.isPicture() ? settings_.pictureReferenceError : settings_.referenceError; }

    const Project& project_;
    const CompareSettings& settings_;
    ReferenceFile kept_;
    bool changed_ = false;
};

}  // namespace luxdeck
