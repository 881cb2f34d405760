#include "analysis/report/report_making.h"

#include "analysis/grids/measurement.h"
#include "analysis/pictures/render.h"
#include "analysis/pictures/show.h"
#include "analysis/report/pdf_writer.h"
#include "analysis/report/report_gather.h"
#include "analysis/report/report_json.h"
#include "engine/algorithms/registry.h"
#include "engine/core/file.h"
#include "engine/io/image_files.h"
#include "tonemap/falsecolor.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <utility>

namespace luxdeck {

namespace {

std::string methodText(const std::string& algorithm) {
    const auto* known = algorithmNamed(algorithm);
    const std::string summary = known != nullptr ? known->summary : "";
    return fmt::format("Light was computed by \"{}\": {}. Every value is the mean of {} independently scrambled quasi-random sample sets; its 95 % interval "
                       "follows from their spread (Student's t). The interval of a grid's mean accounts for its points' errors, together where "
                       "neighbours share light; minimum and uniformity have intervals of their own, since the smallest of uncertain values is "
                       "biased. A requirement is met or not met when the whole interval is on one side of the limit, and undecided otherwise. "
                       "Intervals hold for this model of the room: they say nothing of errors in reflectances, photometry or maintenance "
                       "factors.", algorithm, summary, kReplicates);
}

/// The view at the size that its time can render without much noise, at most its own. About 60,000 pixels a
/// second; a printed page shows no more than the least of it anyway.
View sized(const View& view, double seconds) {
    const double pixels = static_cast<double>(view.width) * view.height;
    const double scale = std::sqrt(std::max(3e5, 6e4 * seconds) / pixels);
    if (scale >= 1) return view;
    View out = view;
    out.width = std::max(1, static_cast<int>(view.width * scale)), out.height = std::max(1, static_cast<int>(view.height * scale));
    return out;
}

ReportView pageOf(const View& view, const RenderResult& picture) {
    ReportView page;
    page.name = view.name;
    page.seconds = picture.seconds;
    page.relativeError = picture.relativeError;
    return page;
}

/// The picture beside the report, as numbers and as it is printed.
Result<void> keep(const View& view, const Image& picture, const std::string& png, const std::filesystem::path& folder) {
    if (folder.empty()) return {};
    std::string name = view.name;
    for (auto& c : name)
        if (c == '/' || c == ' ') c = '-';
    const auto base = folder / name;
    if (auto ok = writeExr(base.string() + ".exr", picture); !ok) return ok;
    return writeFileAtomically(base.string() + ".png", png);
}

Result<void> addToneMapped(const View& view, const RenderResult& picture, const std::filesystem::path& folder, RenderedView& out) {
    auto shown = show(picture.image, {});
    if (!shown) return shown.error();
    auto png = pngBytes(shown->image);
    if (!png) return png.error();
    if (auto kept = keep(view, picture.image, *png, folder); !kept) return kept;
    auto page = pageOf(view, picture);
    page.operatorName = std::string(name(shown->record.op));
    page.operatorText = operatorText(shown->record);
    page.exposure = shown->record.factor > 0 ? fmt::format("1 cd/m² shown as {:.3g} cd/m²", shown->record.factor) : "";
    page.png = *std::move(png);
    out.pages.push_back(std::move(page));
    out.displayTransform = shown->transform;
    return {};
}

Result<void> addFalseColour(const View& view, const RenderResult& picture, RenderedView& out) {
    auto field = tonemap::luminanceField(picture.image);
    if (!field) return field.error();
    tonemap::FalseColourSettings settings;
    settings.legend = false;  // the page draws its own
    settings.range = tonemap::roundedRange(*field, settings.logarithmic);
    auto coloured = tonemap::falseColour(*field, settings);
    if (!coloured) return coloured.error();
    auto png = pngBytes(*coloured);
    if (!png) return png.error();
    auto page = pageOf(view, picture);
    page.operatorName = "false colour";
    page.operatorText = "Luminance as colours; no tone curve and no colour management in between.";
    page.png = *std::move(png);
    page.scale = ColourScale{"cd/m²", settings.range->low, settings.range->high, settings.logarithmic};
    out.pages.push_back(std::move(page));
    return {};
}

}  // namespace

Result<std::optional<RenderedView>> renderReportView(const Project& project, const LitScene& lit, const View& wanted, const ReportViewSettings& settings,
                                                     const Progress& progress) {
    const View view = sized(wanted, settings.seconds);
    RenderSettings how;
    how.algorithm = settings.algorithm;
    how.algorithmSettings = settings.algorithmSettings;
    how.seed = settings.seed;
    how.targetError = 0.005;
    how.timeSeconds = settings.seconds;
    const auto picture = render(project, lit, view, how, progress);
    if (!picture) return picture.error();
    if (picture->samplesPerPixel == 0) return std::optional<RenderedView>();
    RenderedView out;
    if (auto ok = addToneMapped(view, *picture, settings.pictures, out); !ok) return ok.error();
    if (settings.falseColour)
        if (auto ok = addFalseColour(view, *picture, out); !ok) return ok.error();
    return std::optional(std::move(out));
}

ReportContents assembleReport(const Project& project, SolveResult solved, std::string created, ReportParts parts) {
    auto contents = gatherReport(project, std::move(solved), std::move(created));
    contents.methodText = methodText(contents.solve.algorithm);
    contents.comparison = std::move(parts.comparison);
    std::string transform;
    for (auto& view : parts.views) {
        transform = view.displayTransform;
        for (auto& page : view.pages) contents.views.push_back(std::move(page));
    }
    if (!transform.empty()) contents.facts.push_back({"Display transform", "OpenColorIO: " + transform});
    if (!parts.leftOut.empty()) contents.leftOut = std::move(parts.leftOut);
    return contents;
}

std::string createdNow() {
    std::time_t now = std::time(nullptr);
    if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) now = std::strtoll(epoch, nullptr, 10);
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

Result<void> writeReport(const ReportContents& contents, const std::filesystem::path& pdf) {
    const auto json = toJson(contents);
    if (!json) return json.error();
    if (pdf.has_extension())
        if (auto ok = writeFileAtomically(std::filesystem::path(pdf).replace_extension(".json"), *json); !ok) return ok;
    return writePdf(contents, pdf);
}

}  // namespace luxdeck
