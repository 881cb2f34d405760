#pragma once

#include "analysis/compare/comparison.h"
#include "engine/core/image.h"
#include "engine/core/result.h"

#include <string>
#include <vector>

namespace luxdeck {

/// `compare --json`, schema "luxdeck-compare/1"; what is not known is null.
std::string compareJson(const Comparison& comparison);
/// errors  Parse: what was seen, what was expected
Result<Comparison> readCompareJson(const std::string& text, const std::string& where);

/// One row a run; errors in %, an empty cell where nothing is known.
std::string runsCsv(const Comparison& comparison);
/// One row for each point or pixel and algorithm: its signed error at the largest budget.
std::string errorsCsv(const Comparison& comparison);

/// Errors in colours, with a legend: blue where an algorithm is too dark, red where too bright.
///
/// range   ends of the scale: -range .. range, relative
/// name    above the legend
/// errors  InvalidArgument: a map without values
Result<DisplayImage> errorPicture(const ErrorMap& map, double range, const std::string& name);

/// A round end of the scale for all maps of a subject, 1 % at least and 100 % at most: the 98th percentile of the algorithm in the
/// middle, so that one that is far off does not pale the others.
double errorRange(const Comparison& comparison, const std::string& subject);

/// As people read it in a terminal.
std::string compareText(const Comparison& comparison);

}  // namespace luxdeck
