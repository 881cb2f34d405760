#pragma once

#include "analysis/photometry/photometric_facts.h"

#include <string>
#include <vector>

namespace luxdeck {

/// A photometric file that could not be used.
struct RefusedFile {
    std::string file;
    std::string why;   // "file:line: what was seen, what was expected"
};

struct CheckedFile {
    std::string file;
    Photometry photometry;
    PhotometricFacts facts;
};

/// As `luxdeck check` prints it for people.
std::string photometryText(const CheckedFile& checked);

/// As `luxdeck check --json` prints one file (docs/schemas/check.schema.json).
std::string photometryJson(const CheckedFile& checked);

/// Of several files: what each is, and which were refused.
std::string photometryListJson(const std::vector<CheckedFile>& checked, const std::vector<RefusedFile>& refused);

}  // namespace luxdeck
