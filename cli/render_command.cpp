#include "analysis/pictures/render.h"
#include "cli/command.h"
#include "cli/json_text.h"
#include "cli/load.h"
#include "engine/io/image_files.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace luxdeck::cli {

namespace {

struct Options {
    std::vector<std::string> project;
    std::string view, output;
    std::string quantity = "luminance";
    std::vector<int> size;
    Effort effort;
};

RenderSettings settingsOf(const Options& o, const Common& common) {
    RenderSettings s;
    s.algorithm = o.effort.algorithm;
    s.algorithmSettings = o.effort.settings();
    s.quantity = o.quantity == "illuminance" ? Quantity::Illuminance : Quantity::Luminance;
    s.seed = common.seed;
    s.timeSeconds = o.effort.timeSeconds;
    s.samples = o.effort.samples;
    s.targetError = o.effort.targetError.value_or(o.effort.timeSeconds ? 0.0 : 0.1);
    return s;
}

std::string describe(const RenderResult& r, const Options& o, const View& view, bool json) {
    const bool known = r.samplesPerPixel > 1;  // one path says nothing of its own error
    const auto error = known ? fmt::format("error {:.2g} % of the mean luminance (95 %)", 100 * r.relativeError) : "error not known from so few";
    if (!json)
        return fmt::format("{}: {} x {} pixels, {} paths each, {:.1f} s, {}{}\n", o.output, r.image.width(), r.image.height(), r.samplesPerPixel,
                           r.seconds, error,
                           r.complete ? "" : r.valuelessPixels > 0 ? ", incomplete: not all has a value" : ", incomplete: interrupted");
    const nlohmann::ordered_json out{{"schema", "luxdeck-render/1"}, {"output", o.output}, {"view", view.name}, {"complete", r.complete},
                                     {"seconds", r.seconds}, {"samplesPerPixel", r.samplesPerPixel}, {"rays", r.counters.rays},
                                     {"relativeError", known ? nlohmann::ordered_json(r.relativeError) : nlohmann::ordered_json()}, {"targetReached", r.targetReached},
                                     {"rejectedSamples", r.counters.rejected}, {"valuelessPixels", r.valuelessPixels},
                                     {"warnings", r.warnings}, {"quantity", o.quantity}};
    return jsonText(out);
}

Exit runRender(const Options& o, Context& context) {
    if (const auto possible = checkOutput(o.output); !possible) return complain(possible.error());
    auto loaded = load(o.project, context.common.quiet);
    if (!loaded) return complain(loaded.error());
    auto found = findView((*loaded)->project, o.view);
    if (!found) return complain(found.error());
    View view = *std::move(found);
    if (!o.size.empty()) view.width = o.size[0], view.height = o.size[1];
    // Saved now and then, so that even a killed process leaves a picture, marked incomplete.
    const auto save = [&](const RenderResult& part) {
        auto picture = part.image;
        picture.text["luxdeck:complete"] = "false";
        (void)writeExr(o.output, picture).has_value();  // the final write reports what is wrong
    };
    const auto result = render((*loaded)->project, (*loaded)->lit, view, settingsOf(o, context.common), context.progress, save);
    if (!result) return complain(result.error());
    if (result->samplesPerPixel == 0)  // holes would be black surfaces to whoever reads them
        return complain({ErrorCode::Cancelled, "interrupted before every pixel had a sample: nothing is written", o.output});
    if (const auto written = writeExr(o.output, result->image); !written) return complain(written.error());
    printWarnings(result->warnings, context.common.quiet);
    if (const auto told = writeOutput("-", describe(*result, o, view, context.common.json)); !told) return complain(told.error());
    if (result->valuelessPixels > 0) return Exit::NotReached;
    return !result->complete ? Exit::Interrupted : result->targetReached ? Exit::Ok : Exit::NotReached;
}

}  // namespace

Command addRender(CLI::App& program) {
    const auto o = std::make_shared<Options>();
    auto* app = program.add_subcommand("render", "A picture of a view: float EXR in cd/m² with its standard error");
    app->add_option("project", o->project, "project.toml or a scene file; several .rad and .mat files are one scene, in their order")->required()->type_name("PROJECT");
    app->add_option("--view", o->view, "Name of the view, or a Radiance view file (.vf); the first one when not given")->type_name("NAME");
    app->add_option("-o,--output", o->output, "The picture")->required()->check(namedAs(".exr"))->type_name("F.exr");
    app->add_option("--size", o->size, "Width and height in pixels, instead of the view's own")->expected(2)->check(CLI::Range(1, 32768))->type_name("W H");
    app->add_option("--quantity", o->quantity, "luminance of what is seen (cd/m²), or illuminance on it (lx)")
        ->check(CLI::IsMember({"luminance", "illuminance"}))->capture_default_str();
    addEffort(*app, o->effort);
    return {app, [o](Context& context) { return runRender(*o, context); }};
}

}  // namespace luxdeck::cli
