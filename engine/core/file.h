#pragma once

#include "engine/core/result.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace luxdeck {

/// The bytes of a file, at most `maxBytes` of them (a larger file is an error, not a large allocation).
///
/// errors  FileNotFound, Parse (too large, or a folder), OutOfResources
Result<std::string> readFile(const std::filesystem::path& path, std::uint64_t maxBytes = 1ULL << 31);

/// Writes a file whole or not at all: the bytes go to a temporary file beside it, are flushed to disk,
/// and then take its name. On any failure (a full disk) the old file is as it was.
///
/// errors  OutOfResources (disk), InvalidArgument (folder missing or not writable)
Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// The same for libraries that write by name: `write` is given the temporary file's name.
Result<void> writeFileAtomically(const std::filesystem::path& path,
                                 const std::function<Result<void>(const std::filesystem::path&)>& write);

/// 64-bit content hash as 16 hex digits (XXH3).
std::string contentHash(std::string_view bytes);

/// ".OBJ" of "Room.OBJ" as ".obj"; empty where a name has none.
std::string lowerExtension(const std::filesystem::path& path);

}  // namespace luxdeck
