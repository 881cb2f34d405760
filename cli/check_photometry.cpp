#include "cli/check_photometry.h"

#include "analysis/photometry/photometry_summary.h"
#include "cli/streams.h"
#include "engine/core/file.h"
#include "engine/io/photometry.h"
#ifdef LUXDECK_REPORT
#include "analysis/report/photometric_sheet.h"
#endif

#include <fmt/format.h>

#include <filesystem>

namespace luxdeck::cli {

namespace {

Result<void> draw(const CheckedFile& checked, const std::string& path) {
#ifdef LUXDECK_REPORT
    const auto format = sheetFormatOf(path);
    if (!format) return format.error();
    const auto bytes = photometricSheet(checked, *format);
    if (!bytes) return bytes.error();
    return writeOutput(path, *bytes);
#else
    return Error{ErrorCode::Unsupported, "this build draws nothing: it was made without reports", path + checked.file};
#endif
}

/// Before anything is read: whether the drawing can be made at all.
Result<void> checkDrawing(const std::vector<std::string>& files, const std::string& drawing) {
    if (drawing.empty()) return {};
#ifdef LUXDECK_REPORT
    if (const auto format = sheetFormatOf(drawing); !format) return format.error();
#endif
    if (files.size() > 1)
        return Error{ErrorCode::InvalidArgument, fmt::format("{} photometric files, expected one for a drawing", files.size()), drawing};
    return checkOutput(drawing);
}

std::string listText(const std::vector<CheckedFile>& checked, bool several) {
    std::string text;
    for (const auto& each : checked) {
        if (several) text += (text.empty() ? "" : "\n") + each.file + ": ";
        text += photometryText(each);
    }
    return text;
}

}  // namespace

bool isPhotometric(const std::string& path) {
    const auto extension = lowerExtension(path);
    return extension == ".ies" || extension == ".ldt";
}

Exit checkPhotometry(const std::vector<std::string>& files, const std::string& drawing, const Context& context) {
    if (const auto possible = checkDrawing(files, drawing); !possible) return complain(possible.error());
    std::vector<CheckedFile> checked;
    std::vector<RefusedFile> refused;
    Exit exit = Exit::Ok;
    for (const auto& file : files) {
        if (context.progress.cancelled()) return Exit::Interrupted;
        auto photometry = loadPhotometry(file);
        if (!photometry) {
            exit = complain(photometry.error());
            refused.push_back({file, photometry.error().text()});
            continue;
        }
        auto facts = measure(*photometry);
        checked.push_back({file, *std::move(photometry), std::move(facts)});
    }
    const bool several = files.size() > 1;
    if (!several && checked.empty()) return exit;
    if (!drawing.empty())
        if (const auto drawn = draw(checked.front(), drawing); !drawn) return complain(drawn.error());
    const bool json = context.common.json;
    const auto text = !json ? listText(checked, several) : several ? photometryListJson(checked, refused) : photometryJson(checked.front());
    const auto told = writeOutput("-", text);
    return told ? exit : complain(told.error());
}

}  // namespace luxdeck::cli
