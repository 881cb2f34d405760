#pragma once

#include "analysis/validation/cie171.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace luxdeck {

/// A row for each figure: value with its 95 % interval, reference, deviation, verdict; then the largest deviation of each
/// case, what is outside and why, and what the table leaves out.
std::string cie171Text(const std::vector<Cie171Row>& rows);

/// The same as an array of objects; docs/schemas/validate.schema.json.
nlohmann::ordered_json cie171Json(const std::vector<Cie171Row>& rows);

/// Whether every verdict is `Within`.
bool allWithin(const std::vector<Cie171Row>& rows);

}  // namespace luxdeck
