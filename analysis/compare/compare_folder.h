#pragma once

#include "analysis/compare/comparison.h"
#include "engine/core/result.h"

#include <filesystem>
#include <string>

namespace luxdeck {

/// A comparison as files: compare.json, runs.csv, errors.csv and a picture of each view's errors by each algorithm. The folder is
/// there; each file is written whole or not at all.
///
/// errors  OutOfResources (disk), InvalidArgument (folder missing or not writable)
Result<void> writeComparison(const Comparison& comparison, const std::filesystem::path& folder);

/// A file's name of any text: without slashes and spaces.
std::string fileNameOf(std::string text);

}  // namespace luxdeck
