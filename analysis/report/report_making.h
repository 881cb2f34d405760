#pragma once

#include "analysis/report/report_contents.h"
#include "engine/core/progress.h"
#include "engine/transport/lit_scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck {

struct ReportViewSettings {
    std::string algorithm = "path";
    AlgorithmSettings algorithmSettings;
    std::uint64_t seed = 1;
    double seconds = 6;              // of rendering it
    bool falseColour = false;        // a page in false colour too
    std::filesystem::path pictures;  // folder for the picture itself, .exr and .png; empty: not kept
};

/// A view as the report prints it: as an eye would see it, then in false colour where that was asked for.
struct RenderedView {
    std::vector<ReportView> pages;
    std::string displayTransform;    // OpenColorIO's
};

/// Renders a view, at most as large as its time renders without much noise.
///
/// returns  none: interrupted before there was a picture
/// errors   of render(), show() and of writing the pictures
Result<std::optional<RenderedView>> renderReportView(const Project& project, const LitScene& lit, const View& view, const ReportViewSettings& settings,
                                                     const Progress& progress);

/// What a report is put together of, beside the project and what was solved.
struct ReportParts {
    std::vector<RenderedView> views;
    std::optional<std::string> comparison;       // as compareJson() writes it, of the same scene
    std::vector<ReportSection> leftOut;
};

/// errors  none: what is missing is not in the report
ReportContents assembleReport(const Project& project, SolveResult solved, std::string created, ReportParts parts);

/// Now, or SOURCE_DATE_EPOCH for reproducible documents: "2026-11-22T18:40:00Z".
std::string createdNow();

/// The PDF, and beside it its JSON twin of the same name; a device has no place beside it for one. Each whole or not at all.
///
/// errors  of writePdf() and writeFileAtomically()
Result<void> writeReport(const ReportContents& contents, const std::filesystem::path& pdf);

}  // namespace luxdeck
