#include "analysis/stability/stability_table.h"
#include "analysis/validation/cie171_table.h"
#include "cli/command.h"
#include "cli/json_text.h"
#include "engine/algorithms/registry.h"
#include "engine/core/version.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace luxdeck::cli {

namespace {

/// Which tables; none: every one.
struct Options {
    bool cie171 = false;
    bool stability = false;
    std::string algorithm;  // of the stability cases; empty: all
    std::string number;  // of the one case of CIE 171 that is wanted; empty: all
};

Exit runValidate(const Options& asked, const Context& context) {
    const bool all = !asked.cie171 && !asked.stability && asked.number.empty();
    nlohmann::ordered_json json{{"schema", "luxdeck-validate/1"}, {"version", kVersion}, {"seed", context.common.seed}, {"complete", false}};
    std::string text;
    bool met = true;
    if (all || asked.cie171 || !asked.number.empty()) {
        const auto rows = runCie171(context.common.seed, context.progress, asked.number);
        if (rows.empty() && !context.progress.cancelled())
            return complain({ErrorCode::InvalidArgument, fmt::format("case {}, expected one of 5.2 to 5.14", asked.number), "--case"});
        json["cie171"] = cie171Json(rows), text += cie171Text(rows), met = met && allWithin(rows);
    }
    if (all || asked.stability) {
        const auto results = runStability(context.common.seed, context.progress, asked.algorithm);
        json["stability"] = stabilityJson(results), met = met && allMet(results);
        text += (text.empty() ? "" : "\n") + stabilityText(results);
    }
    const bool complete = !context.progress.cancelled();
    json["complete"] = complete;
    const auto told = writeOutput("-", context.common.json ? jsonText(json) : text);
    if (!told) return complain(told.error());
    if (!complete) return Exit::Interrupted;
    return met ? Exit::Ok : Exit::NotMet;
}

}  // namespace

Command addValidate(CLI::App& program) {
    const auto o = std::make_shared<Options>();
    auto* app = program.add_subcommand("validate", "Hold every algorithm to cases whose answer is known: value, expected, deviation in lx or %, interval, verdict; exit 1 when one is not met");
    app->add_flag("--cie171", o->cie171, "The analytical cases of CIE 171:2006, references worked out anew (without an option: both tables)");
    app->add_option("--case", o->number, "One case of CIE 171 alone: 5.2 to 5.14");
    app->add_flag("--stability", o->stability, "Stiff and extreme scenes: reflectances near 1, tiny lights, coordinates of 10^6 m, slivers, NaN");
    std::vector<std::string> names;
    for (const auto& a : algorithms()) names.push_back(a.name);
    app->add_option("--algorithm", o->algorithm, "The stability cases by this one alone")->check(CLI::IsMember(names));
    return {app, [o](Context& context) { return runValidate(*o, context); }};
}

}  // namespace luxdeck::cli
