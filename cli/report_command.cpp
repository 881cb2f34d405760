#ifdef LUXDECK_REPORT

#include "analysis/compare/compare_output.h"
#include "analysis/report/pdf_writer.h"
#include "analysis/report/report_json.h"
#include "analysis/report/report_making.h"
#include "cli/command.h"
#include "cli/load.h"
#include "cli/solve_run.h"
#include "engine/core/file.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck::cli {

namespace {

struct Options {
    std::string project, output, from, pictures, compare;
    Effort effort;
    double viewSeconds = 6;
    bool falseColour = true;
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

/// All of the project's; the first, for the cover, twice as long and in false colour too.
Result<std::vector<RenderedView>> renderViews(const Loaded& loaded, const Options& o, const Context& context) {
    std::vector<RenderedView> out;
    for (const auto& view : loaded.project.views) {
        if (context.progress.cancelled()) break;
        const bool cover = out.empty();
        const ReportViewSettings settings{o.effort.algorithm, o.effort.settings(), context.common.seed, o.viewSeconds * (cover ? 2 : 1), cover && o.falseColour, o.pictures};
        auto rendered = renderReportView(loaded.project, loaded.lit, view, settings, context.progress);
        if (!rendered) return rendered.error();
        if (*rendered) out.push_back(**std::move(rendered));
    }
    return out;
}

Exit finish(const ReportContents& contents, const Options& o, const Context& context) {
    if (const auto written = writeReport(contents, o.output); !written) return complain(written.error());
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
    const auto created = createdNow();
    auto views = renderViews(**loaded, o, context);
    if (!views) return complain(views.error());
    auto contents = assembleReport((*loaded)->project, *std::move(solved), created, {*std::move(views), *comparison, {}});
    if (context.progress.cancelled()) contents.solve.complete = false;
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
