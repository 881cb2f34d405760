#include "analysis/grids/layers.h"
#include "analysis/grids/solve_json.h"
#include "analysis/grids/solver.h"
#include "cli/command.h"
#include "cli/load.h"
#include "cli/solve_run.h"
#include "engine/core/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::cli {

namespace {

/// As many decimals as the interval leaves meaning.
std::string valueText(const Interval& v) {
    if (!std::isfinite(v.ci95)) return "not known";
    const int decimals = v.ci95 <= 0 ? 1 : std::clamp(static_cast<int>(std::ceil(-std::log10(v.ci95))) + 1, 0, 4);
    return fmt::format("{:.{}f} ± {:.{}f}", v.value, decimals, v.ci95, decimals);
}

std::string statisticText(const char* name, const char* unit, const JudgedInterval& s) {
    std::string text = fmt::format("  {:<5} {} {}", name, valueText(s.interval), unit);
    if (s.required) text += fmt::format("   required {}{}{}: {}", *s.required, *unit != 0 ? " " : "", unit, verdictText(s.verdict));
    return text + "\n";
}

std::string gridText(const GridResult& g) {
    std::string text = fmt::format("{}  ({}{})\n", g.name, g.columns > 0 ? fmt::format("{} x {} points, {:.2f} x {:.2f} m apart", g.columns, g.rows, g.spacingU, g.spacingV)
                                                                          : fmt::format("{} free points", g.points.size()),
                                   g.kind == GridKind::Cylindrical ? ", cylindrical" : "");
    if (g.columns == 0)
        for (const auto& p : g.points)
            text += fmt::format("  {:.3f} {:.3f} {:.3f}  {} lx  (direct {:.1f}, indirect {:.1f})\n", p.position.x, p.position.y, p.position.z,
                                valueText(p.total), p.direct.value, p.indirect.value);
    text += statisticText("Ēm", "lx", g.mean) + statisticText("Emin", "lx", g.minimum) + statisticText("Uo", "", g.uniformity);
    return text;
}

const char* stateText(const SolveResult& r) {
    if (r.withheldPoints > 0) return "incomplete: numbers are withheld";
    return !r.complete ? "incomplete: interrupted" : r.targetReached ? "complete" : "target error not reached";
}

}  // namespace

std::string solveText(const SolveResult& r) {
    std::string text = fmt::format("{}: {} ({}), seed {}, {:.1f} s after {:.1f} s of set-up, {:.2f} million paths\n", r.project, r.algorithm,
                                   stateText(r), r.seed,
                                   r.seconds, r.setupSeconds, static_cast<double>(r.samples) * 1e-6);
    if (r.ambientLux != 0) text += fmt::format("constant ambient term: {} lx in every indirect value\n", r.ambientLux);
    for (const auto& g : r.grids) text += "\n" + gridText(g);
    text += "\nIntervals are 95 %.";
    if (!r.leftOut.empty()) text += " Left out, as this scene does not need it:";
    for (const auto& l : r.leftOut) text += fmt::format("\n  {} ({})", l.what, l.why);
    text += fmt::format("\nTruncated: {:.2g} of the energy.", r.truncatedFraction);
    if (r.rejectedSamples > 0) text += fmt::format(" Of {} samples a part is missing, as something has no value.", r.rejectedSamples);
    return text + "\n";
}

Exit exitOf(const SolveResult& r) {
    if (!r.complete && r.withheldPoints == 0) return Exit::Interrupted;
    for (const auto& g : r.grids)
        for (const auto* s : {&g.mean, &g.minimum, &g.uniformity})
            if (s->verdict == Verdict::NotMet) return Exit::NotMet;
    return r.complete && r.targetReached ? Exit::Ok : Exit::NotReached;
}

Result<SolveResult> runSolve(const Loaded& loaded, const Effort& effort, const Context& context, double defaultError,
                             bool byLuminaire) {
    SolveSettings settings;
    settings.algorithm = effort.algorithm;
    settings.algorithmSettings = effort.settings();
    settings.seed = context.common.seed;
    settings.timeSeconds = effort.timeSeconds;
    settings.samples = effort.samples;
    settings.byLuminaire = byLuminaire;
    settings.targetError = effort.targetError.value_or(effort.timeSeconds ? 0.0 : defaultError);
    auto result = solve(loaded.project, loaded.lit, settings, context.progress);
    if (result) result->setupSeconds += loaded.seconds;
    return result;
}

namespace {

/// "NAME=0.5", NAME to the last =.
Result<std::map<std::string, double>> dimmingsOf(const std::vector<std::string>& texts) {
    std::map<std::string, double> out;
    for (const auto& text : texts) {
        const auto sign = text.rfind('=');
        const std::string number = sign == std::string::npos ? "" : text.substr(sign + 1);
        char* end = nullptr;
        const double value = std::strtod(number.c_str(), &end);
        if (number.empty() || *end != 0 || sign == 0)
            return Error{ErrorCode::InvalidArgument, fmt::format("--dim \"{}\", expected NAME=X with X in 0 .. 1", text)};
        out[text.substr(0, sign)] = value;
    }
    return out;
}

/// The same output as a solve, from its layers.
Exit solveFromLayers(const std::vector<std::string>& projectFiles, const std::string& file, const std::vector<std::string>& dim, const std::string& output,
                     const Context& context) {
    const auto dimmings = dimmingsOf(dim);
    if (!dimmings) return complain(dimmings.error());
    const auto project = loadProject(std::vector<std::filesystem::path>(projectFiles.begin(), projectFiles.end()));
    if (!project) return complain(project.error());
    const auto bytes = readFile(file);
    if (!bytes) return complain(bytes.error());
    const auto layers = readLayersJson(*bytes, file);
    if (!layers) return complain(layers.error());
    const auto result = recombine(*project, *layers, *dimmings);
    if (!result) return complain(result.error());
    const auto written = writeOutput(output, context.common.json ? solveJson(*result) : solveText(*result));
    if (!written) return complain(written.error());
    return exitOf(*result);
}

}  // namespace

Command addSolve(CLI::App& program) {
    struct Options {
        std::vector<std::string> project;
        std::string output = "-", layersOut, layers;
        std::vector<std::string> dim;
        bool byLuminaire = false;
        Effort effort;
    };
    const auto o = std::make_shared<Options>();
    auto* app = program.add_subcommand("solve", "Illuminance on every calculation grid: value ± 95 % interval, Em, Emin, Uo and verdicts");
    app->add_option("project", o->project, "project.toml")->required()->type_name("PROJECT");
    app->add_option("-o,--output", o->output, "File for the result; - is stdout")->capture_default_str()->type_name("FILE");
    app->add_flag("--by-luminaire", o->byLuminaire, "Keep the light of each luminaire apart (those of one name together): layers in --json");
    app->add_option("--layers-out", o->layersOut, "File for the layers, to be dimmed later without solving; implies --by-luminaire")->type_name("FILE");
    auto* layers = app->add_option("--layers", o->layers, "Results from this file of layers instead of solving")->type_name("FILE");
    app->add_option("--dim", o->dim, "With --layers: a new dimming, 0..1, of the luminaires of a name (or of all whose names begin so: NAME*)")
        ->type_name("NAME=X")->needs(layers);
    addEffort(*app, o->effort);
    return {app, [o](Context& context) {
        if (const auto possible = checkOutput(o->output); !possible) return complain(possible.error());
        if (!o->layers.empty()) return solveFromLayers(o->project, o->layers, o->dim, o->output, context);
        if (!o->layersOut.empty())
            if (const auto possible = checkOutput(o->layersOut); !possible) return complain(possible.error());
        auto loaded = load(o->project, context.common.quiet);
        if (!loaded) return complain(loaded.error());
        const auto result = runSolve(**loaded, o->effort, context, 0.02, o->byLuminaire || !o->layersOut.empty());
        if (!result) return complain(result.error());
        if (!o->layersOut.empty())
            if (const auto kept = writeOutput(o->layersOut, layersJson(*result->layers)); !kept) return complain(kept.error());
        const auto written = writeOutput(o->output, context.common.json ? solveJson(*result) : solveText(*result));
        if (!written) return complain(written.error());
        return exitOf(*result);
    }};
}

}  // namespace luxdeck::cli
