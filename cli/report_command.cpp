#ifdef LUXDECK_REPORT

#include "analysis/compare/compare_output.h"
#include "analysis/grids/measurement.h"
#include "analysis/pictures/render.h"
#include "analysis/pictures/show.h"
#include "analysis/report/pdf_writer.h"
#include "analysis/report/report_gather.h"
#include "analysis/report/report_json.h"
#include "cli/command.h"
#include "cli/load.h"
#include "cli/solve_run.h"
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
#include <filesystem>
#include <memory>
#include <optional>

namespace luxdeck::cli {

namespace {

struct Options {
    std::string project, output, from, pictures, compare;
    Effort effort;
    double viewSeconds = 6;
    bool falseColour = true;
};

/// Now, or SOURCE_DATE_EPOCH for reproducible documents.
std::string createdNow() {
    std::time_t now = std::time(nullptr);
    if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) now = std::strtoll(epoch, nullptr, 10);
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

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

/// Views as an eye would see them, the first in false colour too.
class ViewPages {
public:
    ViewPages(const Loaded& loaded, const Options& o, Context& context) : loaded_(loaded), o_(o), context_(context) {}

    Result<void> add(const View& wanted, bool cover, ReportContents& contents) {
        const double seconds = o_.viewSeconds * (cover ? 2 : 1);
        const View view = sized(wanted, seconds);
        RenderSettings settings;
        settings.algorithm = o_.effort.algorithm;
        settings.algorithmSettings = o_.effort.settings();
        settings.seed = context_.common.seed;
        settings.targetError = 0.005;
        settings.timeSeconds = seconds;
        const auto picture = render(loaded_.project, loaded_.lit, view, settings, context_.progress);
        if (!picture) return picture.error();
        if (picture->samplesPerPixel == 0) return {};  // interrupted before there was one
        if (auto ok = addToneMapped(view, *picture, contents); !ok) return ok;
        return cover && o_.falseColour ? addFalseColour(view, *picture, contents) : Result<void>{};
    }

private:
    static ReportView pageOf(const View& view, const RenderResult& picture) {
        ReportView page;
        page.name = view.name;
        page.seconds = picture.seconds;
        page.relativeError = picture.relativeError;
        return page;
    }

    Result<void> addToneMapped(const View& view, const RenderResult& picture, ReportContents& contents) const {
        auto shown = show(picture.image, {});
        if (!shown) return shown.error();
        auto png = pngBytes(shown->image);
        if (!png) return png.error();
        if (auto saved = save(view, picture.image, *png); !saved) return saved;
        auto page = pageOf(view, picture);
        page.operatorName = std::string(name(shown->record.op));
        page.operatorText = operatorText(shown->record);
        page.exposure = shown->record.factor > 0 ? fmt::format("1 cd/m² shown as {:.3g} cd/m²", shown->record.factor) : "";
        page.png = *std::move(png);
        contents.views.push_back(std::move(page));
        displayTransform_ = shown->transform;
        return {};
    }

    /// The picture beside the report, as numbers and as it is printed.
    Result<void> save(const View& view, const Image& picture, const std::string& png) const {
        if (o_.pictures.empty()) return {};
        std::string name = view.name;
        for (auto& c : name)
            if (c == '/' || c == ' ') c = '-';
        const auto base = std::filesystem::path(o_.pictures) / name;
        if (auto ok = writeExr(base.string() + ".exr", picture); !ok) return ok;
        return writeFileAtomically(base.string() + ".png", png);
    }

    Result<void> addFalseColour(const View& view, const RenderResult& picture, ReportContents& contents) const {
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
        contents.views.push_back(std::move(page));
        return {};
    }

    const Loaded& loaded_;
    const Options& o_;
    Context& context_;
    mutable std::string displayTransform_;

public:
    [[nodiscard]] const std::string& displayTransform() const { return displayTransform_; }
};

/// The comparison that goes in; one of another scene would be a page about another room.
Result<std::optional<std::string>> comparisonOf(const Options& o, const Project& project) {
    if (o.compare.empty()) return std::optional<std::string>();
    const auto bytes = readFile(o.compare);
    if (!bytes) return bytes.error();
    const auto comparison = readCompareJson(*bytes, o.compare);
    if (!comparison) return comparison.error();
    if (comparison->sceneHash != project.scene.hash)
        return Error{ErrorCode::InvalidArgument, fmt::format("is of scene {}, expected {}: compare this project anew", comparison->sceneHash, project.scene.hash), o.compare};
    return std::optional(compareJson(*comparison));
}

/// The PDF and its twin; a device has no place beside it for one.
Result<void> writeBoth(const ReportContents& contents, const Options& o) {
    const auto json = toJson(contents);
    if (!json) return json.error();
    const std::filesystem::path pdf(o.output);
    if (pdf.has_extension())
        if (auto ok = writeFileAtomically(std::filesystem::path(pdf).replace_extension(".json"), *json); !ok) return ok;
    return writePdf(contents, pdf);
}

Exit finish(const ReportContents& contents, const Options& o, const Context& context) {
    if (const auto written = writeBoth(contents, o); !written) return complain(written.error());
    if (context.common.json) {
        const auto json = toJson(contents);
        if (!json) return complain(json.error());
        if (const auto told = writeOutput("-", *json); !told) return complain(told.error());
    } else if (!context.common.quiet) {
        const auto text = fmt::format("{}\nreport: {} and its JSON twin\n", solveText(contents.solve), o.output);
        if (const auto told = writeOutput("-", text); !told) return complain(told.error());
    }
    return exitOf(contents.solve);
}

Exit runReport(const Options& o, Context& context) {
    if (const auto possible = checkOutput(o.output); !possible) return complain(possible.error());
    if (!o.from.empty()) {
        const auto bytes = readFile(o.from);
        if (!bytes) return complain(bytes.error());
        auto contents = fromJson(*bytes);
        if (!contents) return complain({contents.error().code, contents.error().text(), o.from});
        const auto written = writePdf(*contents, o.output);
        return written ? Exit::Ok : complain(written.error());
    }
    auto loaded = load(o.project, context.common.quiet);
    if (!loaded) return complain(loaded.error());
    const auto comparison = comparisonOf(o, (*loaded)->project);
    if (!comparison) return complain(comparison.error());
    auto solved = runSolve(**loaded, o.effort, context, 0.02);
    if (!solved) return complain(solved.error());
    auto contents = gatherReport((*loaded)->project, *std::move(solved), createdNow());
    contents.methodText = methodText(o.effort.algorithm);
    contents.comparison = *comparison;
    ViewPages pages(**loaded, o, context);
    bool first = true;
    for (const auto& view : (*loaded)->project.views) {
        if (context.progress.cancelled()) break;
        if (const auto ok = pages.add(view, first, contents); !ok) return complain(ok.error());
        first = false;
    }
    if (context.progress.cancelled()) contents.solve.complete = false;
    if (!pages.displayTransform().empty()) contents.facts.push_back({"Display transform", "OpenColorIO: " + pages.displayTransform()});
    return finish(contents, o, context);
}

}  // namespace

Command addReport(CLI::App& program) {
    const auto o = std::make_shared<Options>();
    auto* app = program.add_subcommand("report", "The report as PDF with a JSON twin: verdicts, plans, schedule, pictures, error against run time");
    auto* project = app->add_option("project", o->project, "project.toml")->type_name("PROJECT");
    app->add_option("-o,--output", o->output, "The PDF; the twin lies beside it as .json")->required()->check(namedAs(".pdf"))->type_name("F.pdf");
    auto* from = app->add_option("--from", o->from, "Make the PDF from a JSON twin instead of a project")->type_name("F.json");
    project->excludes(from);
    app->add_option_function<std::string>("--view-time", [o](const std::string& text) {
        if (const auto wrong = parseSeconds(text, o->viewSeconds); !wrong.empty()) throw CLI::ValidationError("--view-time", wrong);
    }, "Time for each picture in seconds (default 6)")->type_name("S");
    app->add_option("--pictures", o->pictures, "Folder for the pictures themselves: .exr in cd/m² and .png")->check(CLI::ExistingDirectory)->type_name("DIR");
    app->add_option("--compare", o->compare, "Pages about a comparison of algorithms: compare.json of luxdeck compare -o FOLDER")->excludes(from)->type_name("F.json");
    app->add_flag("!--no-false-colour", o->falseColour, "Leave out the false-colour page");
    addEffort(*app, o->effort);
    app->final_callback([o] {
        if (o->project.empty() && o->from.empty()) throw CLI::RequiredError("PROJECT or --from");
    });
    return {app, [o](Context& context) { return runReport(*o, context); }};
}

}  // namespace luxdeck::cli

#endif
