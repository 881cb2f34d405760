#pragma once

#include "analysis/photometry/photometry_summary.h"
#include "engine/core/result.h"

#include <filesystem>
#include <string>

namespace luxdeck {

enum class SheetFormat { Png, Pdf, Svg };

/// A luminaire's photometry on one A4 sheet: polar curve, C planes, and what was measured. The same file gives the
/// same bytes.
///
/// errors  OutOfResources: no font is installed
Result<std::string> photometricSheet(const CheckedFile& checked, SheetFormat format);

/// The format that a name asks for.
///
/// errors  InvalidArgument: another extension than .png, .pdf and .svg
Result<SheetFormat> sheetFormatOf(const std::filesystem::path& path);

}  // namespace luxdeck
