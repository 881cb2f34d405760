#pragma once

#include "analysis/report/report_contents.h"

#include <filesystem>

namespace luxdeck {

/// Writes the report as a PDF, whole or not at all. Equal contents give equal bytes on one machine: the
/// dates in the file are those of the contents. Text is searchable and its fonts are embedded.
/// Needs no display: without a QGuiApplication one is made on Qt's offscreen platform, in the first calling
/// thread, and kept.
///
/// errors  InvalidArgument (a view's picture cannot be read, the folder is missing), Parse (the comparison), OutOfResources (disk;
///         no font is installed)
Result<void> writePdf(const ReportContents& contents, const std::filesystem::path& path);

/// The same as bytes.
Result<std::string> pdfBytes(const ReportContents& contents);

}  // namespace luxdeck
