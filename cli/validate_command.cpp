#include "analysis/stability/stability_table.h"
#include "cli/command.h"
#include "cli/json_text.h"
#include "engine/core/version.h"

#include <memory>

namespace luxdeck::cli {

namespace {

/// Which tables; none: every one.
struct Options {
    bool stability = false;
};

Exit runValidate(const Context& context) {
    const auto results = runStability(context.common.seed, context.progress);
    const bool complete = !context.progress.cancelled();
    nlohmann::ordered_json json{{"schema", "luxdeck-validate/1"}, {"version", kVersion}, {"seed", context.common.seed}, {"complete", complete}};
    json["stability"] = stabilityJson(results);
    const auto told = writeOutput("-", context.common.json ? jsonText(json) : stabilityText(results));
    if (!told) return complain(told.error());
    if (!complete) return Exit::Interrupted;
    return allMet(results) ? Exit::Ok : Exit::NotMet;
}

}  // namespace

Command addValidate(CLI::App& program) {
    const auto o = std::make_shared<Options>();
    auto* app = program.add_subcommand("validate", "Hold every algorithm to cases whose answer is known: value, expected, deviation in lx or %, interval, verdict; exit 1 when one is not met");
    app->add_flag("--stability", o->stability, "Stiff and extreme scenes: reflectances near 1, tiny lights, coordinates of 10^6 m, slivers, NaN (the default)");
    return {app, [o](Context& context) { return runValidate(context); }};
}

}  // namespace luxdeck::cli
