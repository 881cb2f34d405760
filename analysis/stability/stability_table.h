#pragma once

#include "analysis/stability/stability.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace luxdeck {

/// A row for each case and algorithm: value, interval, expected, deviation, what was rejected and cut off, verdict;
/// below it the messages of refusals and, of what is not met, where the expected value is from.
std::string stabilityText(const std::vector<StabilityResult>& results);

/// The same as an array of objects; docs/schemas/validate.schema.json.
nlohmann::ordered_json stabilityJson(const std::vector<StabilityResult>& results);

/// Whether every verdict is `Met`.
bool allMet(const std::vector<StabilityResult>& results);

}  // namespace luxdeck
