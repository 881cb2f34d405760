#pragma once

#include "engine/core/result.h"
#include "engine/scene/candela_table.h"

#include <filesystem>
#include <string_view>

namespace luxdeck {

/// An IES LM-63 file (1986, 1991, 1995, 2002, 2019; types A, B, C; TILT).
/// `name` is what messages call the file; it also resolves a TILT file beside it.
Result<Photometry> readIes(std::string_view bytes, const std::filesystem::path& name);

/// An EULUMDAT file, all five symmetries.
Result<Photometry> readEulumdat(std::string_view bytes, const std::filesystem::path& name);

/// Either, by extension, else by content.
Result<Photometry> loadPhotometry(const std::filesystem::path& path);

}  // namespace luxdeck
