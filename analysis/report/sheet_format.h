#pragma once

#include "engine/core/result.h"

#include <filesystem>

namespace luxdeck {

/// What a drawing of one page can be written as.
enum class SheetFormat { Png, Pdf, Svg };

/// The format that a name asks for.
///
/// errors  InvalidArgument: another extension than .png, .pdf and .svg
Result<SheetFormat> sheetFormatOf(const std::filesystem::path& path);
/// ".png", ".pdf", ".svg".
const char* extensionOf(SheetFormat format);

}  // namespace luxdeck
