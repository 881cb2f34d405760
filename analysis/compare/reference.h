#pragma once

#include "analysis/compare/subject.h"

#include <filesystem>
#include <map>
#include <optional>

namespace luxdeck {

/// The truth about one subject, as far as it is known.
struct Reference {
    std::string key;               // Subject::key()
    std::string algorithm;
    std::vector<Field> parts;      // kReferenceParts x N, independent of each other; numbers that a float holds
    std::uint64_t samples = 0;     // for each value, of all parts
    double seconds = 0;
    bool reused = false;           // read from a file

    [[nodiscard]] ReferenceFields fields(const Subject& subject) const;
};

/// Enough that the variance of their mean is known to a half; few enough that they can be kept.
inline constexpr std::size_t kReferenceParts = 8;

/// Rms over the values of the 95 % half-width over the scale.
double relativeError95(const ReferenceFields& fields);

struct ReferenceSettings {
    std::string algorithm = "shared";
    AlgorithmSettings algorithmSettings;
    std::uint64_t seed = 1;
    double error = 0.01;           // relativeError95() to come to
};

/// Measures until the error is reached or the work is cancelled: then what there is, if every part has something.
///
/// errors  InvalidArgument: an algorithm that is biased or without interreflection, or none of that name; Cancelled: before there was anything
Result<Reference> measureReference(const Subject& subject, const LitScene& lit, const ReferenceSettings& settings, const Progress& progress);

/// References that were kept, by Subject::key(), and the scene that they belong to.
struct ReferenceFile {
    std::string sceneHash, projectHash;
    std::map<std::string, Reference> references;
};

/// JSON, schema "luxdeck-reference/1": what is read again is the same to the last bit.
std::string referenceJson(const ReferenceFile& file);
/// errors  Parse
Result<ReferenceFile> readReferenceJson(const std::string& text, const std::string& where);

}  // namespace luxdeck
