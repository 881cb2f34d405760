#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace luxdeck::gltf {

/// The bytes of a "data:" URI, or nothing when it is another kind.
/// errors  Parse: not base64, or cut off
std::optional<Result<std::string>> decodeDataUri(std::string_view uri);

/// The file that a relative reference names. Only files in `folder` or below it are given: a model from
/// elsewhere must not be able to ask for /etc/passwd or ../../secret.
/// errors  Unsupported: an absolute path, a way out of the folder, another scheme
Result<std::filesystem::path> resolveBelow(const std::filesystem::path& folder, std::string_view reference);

/// %20 and the like.
std::string percentDecoded(std::string_view uri);

}  // namespace luxdeck::gltf
