#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace luxdeck::cli {

/// JSON as every command prints it. Names that are not UTF-8 (of files, say) get replacement characters:
/// they are no reason to fail.
inline std::string jsonText(const nlohmann::ordered_json& json, int indent = 1) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace luxdeck::cli
