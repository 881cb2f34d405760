#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace luxdeck::test {

/// What a document has that its schema does not allow, each with its place ("/grids/0/name: ..."); empty when it is
/// valid. Knows the part of JSON Schema 2020-12 that docs/schemas uses; a keyword beyond it is a complaint too, so that
/// nothing in a schema is passed over silently. References go to $defs of the same schema.
std::vector<std::string> complaintsOf(const nlohmann::ordered_json& document, const nlohmann::ordered_json& schema);

/// What is missing in a schema for a reader: objects that allow unknown keys, keys without a description.
std::vector<std::string> schemaGaps(const nlohmann::ordered_json& schema);

}  // namespace luxdeck::test
