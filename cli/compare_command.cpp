#include "analysis/compare/compare.h"
#include "analysis/compare/compare_folder.h"
#include "analysis/compare/compare_output.h"
#include "analysis/compare/volume_pairs.h"
#include "cli/command.h"
#include "cli/load.h"
#ifdef LUXDECK_REPORT
#include "analysis/report/compare_plot.h"
#endif

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::cli {

namespace {

namespace fs = std::filesystem;

struct Options {
    std::vector<std::string> project;
    std::string folder;
    std::vector<std::string> views;
    bool grids = true, volumes = false;
    CompareSettings settings;
};

/// The folder, made if it is not there, asked before long work whether it takes files.
Result<void> prepareFolder(const std::string& folder) {
    if (folder.empty()) return {};
    std::error_code ec;
    if (!fs::is_directory(folder, ec)) fs::create_directory(folder, ec);
    if (!fs::is_directory(folder, ec)) return Error{ErrorCode::InvalidArgument, "is no folder and cannot be made one", folder};
    return checkOutput((fs::path(folder) / "compare.json").string());
}

/// The first view unless others, all or none are asked for.
std::vector<std::string> viewsOf(const Options& o, const Project& project) {
    if (o.views == std::vector<std::string>{"none"}) return {};
    if (!o.views.empty()) return o.views;
    if (project.views.empty()) return {};
    return {project.views.front().name};
}

/// The kept reference is the one named, or the folder's own; that one is replaced when the project has changed.
CompareSettings settingsOf(const Options& o, const Project& project, const Context& context) {
    auto settings = o.settings;
    settings.seed = context.common.seed;
    settings.views = viewsOf(o, project);
    settings.grids = o.grids;
    if (settings.referenceFile.empty() && !o.folder.empty()) {
        settings.referenceFile = fs::path(o.folder) / "reference.json";
        settings.renewReference = true;
    }
    return settings;
}

Result<void> writeFolder(const Comparison& comparison, const fs::path& folder) {
    if (auto ok = writeComparison(comparison, folder); !ok) return ok;
#ifdef LUXDECK_REPORT
    return writeComparePlots(comparison, folder);
#else
    return {};
#endif
}

Exit runCompare(const Options& o, Context& context) {
    if (const auto possible = prepareFolder(o.folder); !possible) return complain(possible.error());
    const auto loaded = load(o.project, context.common.quiet);
    if (!loaded) return complain(loaded.error());
    const auto& project = (*loaded)->project;
    auto result = compare(project, (*loaded)->lit, settingsOf(o, project, context), context.progress);
    if (!result) return complain(result.error());
    if (o.volumes && result->complete)
        if (const auto done = compareVolumePairs(project, (*loaded)->lit, o.settings.algorithmSettings, fs::path(o.folder) / "volumes", context.progress, *result); !done)
            return complain(done.error());
    if (!o.folder.empty())
        if (const auto written = writeFolder(*result, o.folder); !written) return complain(written.error());
    if (!context.common.json) printWarnings(result->warnings, context.common.quiet);
    const auto told = writeOutput("-", context.common.json ? compareJson(*result) : compareText(*result));
    if (!told) return complain(told.error());
    return result->complete ? Exit::Ok : Exit::Interrupted;
}

template <class Parse>
void addParsed(CLI::App& app, const std::string& name, double& value, Parse parse, const std::string& text, const std::string& type) {
    app.add_option_function<std::string>(name, [&value, parse, name](const std::string& given) {
        if (const auto wrong = parse(given, value); !wrong.empty()) throw CLI::ValidationError(name, wrong);
    }, text)->type_name(type);
}

}  // namespace

Command addCompare(CLI::App& program) {
    const auto o = std::make_shared<Options>();
    auto& s = o->settings;
    auto* app = program.add_subcommand("compare", "Algorithms against each other on one project: error against run time, bias, memory, where the errors are");
    app->add_option("project", o->project, "project.toml")->required()->type_name("PROJECT");
    auto* output = app->add_option("-o,--output", o->folder, "Folder for compare.json, runs.csv, errors.csv, plots, error pictures and the reference; made if it is not there")->type_name("FOLDER");
    app->add_flag("--volumes", o->volumes, "Irradiance volumes too: the project's [[volume]] by each algorithm and by path as the reference, and their differences, as .vtu in FOLDER/volumes")->needs(output);
    app->add_option("--algorithms", s.algorithms, "Names, separated by commas; all of them when not given")->delimiter(',')->type_name("A,B");
    addParsed(*app, "--budget", s.budgetSeconds, parseSeconds, "Time of the largest run of each algorithm (default 4 s); each rung below takes half", "S");
    app->add_option_function<std::uint32_t>("--samples", [o](std::uint32_t n) { o->settings.samples = n; },
        "Exactly this many paths for each point or pixel of the largest run, instead of a budget: values depend on the seed alone")->check(CLI::Range(1, 1 << 24))->type_name("N");
    app->add_flag("--core-time", s.coreTime, "Times and budgets in seconds of all cores together: for machines that others use too");
    app->add_option("--rungs", s.rungs, "Budgets, each half of the next")->check(CLI::Range(2, 12))->capture_default_str();
    app->add_option("--repetitions", s.repetitions, "Of each run with independent seeds: the errors' own errors are from these")->check(CLI::Range(3, 64))->capture_default_str();
    app->add_option("--reference", s.referenceAlgorithm, "Algorithm of the reference: an unbiased one")->capture_default_str()->type_name("NAME");
    addParsed(*app, "--reference-error", s.referenceError, parsePercent, "What the grids' reference is to be known to (95 %, rms over the points; default 1%)", "P");
    addParsed(*app, "--picture-reference-error", s.pictureReferenceError, parsePercent, "The same of pictures, over the pixels (default 10%)", "P");
    app->add_option("--reference-file", s.referenceFile, "Where the reference is kept, and found again by the next comparison of the same project")->type_name("F.json");
    app->add_option("--views", o->views, "Names of the views whose pictures are compared, separated by commas; all; none (the first one when not given)")->delimiter(',')->type_name("V,W");
    app->add_option("--height", s.pictureHeight, "Of these pictures, in pixels")->check(CLI::Range(8, 4096))->capture_default_str();
    app->add_flag("!--no-grids", o->grids, "Leave out the calculation grids");
    app->add_option("--ambient", s.algorithmSettings.ambientLux, "Constant term of the ambient algorithm, lx")->check(CLI::Range(0.0, 1e6))->capture_default_str();
    return {app, [o](Context& context) { return runCompare(*o, context); }};
}

}  // namespace luxdeck::cli
