#include "analysis/pictures/show.h"
#include "cli/command.h"
#include "cli/json_text.h"
#include "engine/io/image_files.h"
#include "tonemap/falsecolor.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

namespace luxdeck::cli {

namespace {

struct Options {
    std::string input, output;
    std::string op = "human";
    std::optional<double> exposure;
    double white = 100, black = 1;
    std::string ocioView;
    bool noVeil = false, noAcuity = false, noColourLoss = false, noWhiteBalance = false;
    bool falseColour = false, linear = false, isolines = false;
    std::string map = "dusk";
    std::vector<double> range;
};

tonemap::ToneMapSettings settingsOf(const Options& o, tonemap::Operator op) {
    tonemap::ToneMapSettings s;
    s.op = op;
    s.exposure = o.exposure;
    s.display = {o.white, o.black};
    if (o.noVeil) s.effects.veil = false;
    if (o.noAcuity) s.effects.acuity = false;
    if (o.noColourLoss) s.effects.colour = false;
    return s;
}

nlohmann::ordered_json recordJson(const tonemap::ToneMapRecord& r) {
    nlohmann::ordered_json out{{"operator", std::string(name(r.op))}, {"mapping", r.mapping}, {"why", r.why},
                               {"factor", r.factor}, {"displayMax", r.display.maxCdM2}, {"displayMin", r.display.minCdM2},
                               {"worldMin", r.worldMinCdM2}, {"worldMax", r.worldMaxCdM2}, {"worldLogMean", r.worldLogMeanCdM2},
                               {"viewAssumed", r.viewAssumed}};
    for (const auto& e : r.effects) out["effects"].push_back({{"effect", e.effect}, {"applied", e.applied}, {"why", e.why}});
    for (const auto& p : r.curve) out["curve"].push_back({p.worldCdM2, p.displayCdM2});
    out["nonFinitePixels"] = r.nonFinitePixels, out["negativePixels"] = r.negativePixels, out["clippedPixels"] = r.clippedPixels;
    return out;
}

std::string textOf(const Image& image, const std::string& key, const std::string& otherwise) {
    const auto at = image.text.find(key);
    return at == image.text.end() ? otherwise : at->second;
}

Result<DisplayImage> inFalseColour(const Image& image, const Options& o) {
    auto field = tonemap::luminanceField(image);
    if (!field) return field.error();
    auto map = tonemap::colourMapNamed(o.map);
    if (!map) return map.error();
    const bool illuminance = textOf(image, "luxdeck:quantity", "luminance") == "illuminance";
    tonemap::FalseColourSettings s;
    s.map = *map;
    s.logarithmic = !o.linear;
    if (!o.range.empty()) s.range = {o.range[0], o.range[1]};
    s.quantity = illuminance ? "Illuminance" : "Luminance";
    s.unit = illuminance ? "lx" : "cd/m²";
    if (o.isolines) s.isolines.emplace();
    return tonemap::falseColour(*field, s);
}

Result<std::pair<DisplayImage, nlohmann::ordered_json>> convert(const Image& image, const Options& o) {
    if (o.falseColour) {
        auto shown = inFalseColour(image, o);
        if (!shown) return shown.error();
        nlohmann::ordered_json about(shown->text);
        return std::pair{*std::move(shown), std::move(about)};
    }
    auto op = tonemap::operatorNamed(o.op);
    if (!op) return op.error();
    auto shown = show(image, settingsOf(o, *op), {!o.noWhiteBalance, o.ocioView});
    if (!shown) return shown.error();
    if (o.isolines) {
        auto field = tonemap::luminanceField(image);
        if (!field) return field.error();
        if (auto drawn = tonemap::drawIsolines(shown->image, *field, {}, !o.linear); !drawn) return drawn.error();
    }
    auto about = recordJson(shown->record);
    about["displayTransform"] = shown->transform;
    return std::pair{std::move(shown->image), std::move(about)};
}

std::string describe(const DisplayImage& picture, const nlohmann::ordered_json& about, const Options& o, const Common& common) {
    if (common.json) {
        nlohmann::ordered_json out{{"schema", "luxdeck-tonemap/1"}, {"output", o.output}};
        out.update(about);
        return jsonText(out);
    }
    if (common.quiet) return {};
    std::string text = fmt::format("{}: {} x {} pixels\n", o.output, picture.width, picture.height);
    for (const auto& [key, value] : picture.text) text += fmt::format("  {}: {}\n", key, value);
    return text;
}

Exit runTonemap(const Options& o, Context& context) {
    if (const auto possible = checkOutput(o.output); !possible) return complain(possible.error());
    const auto image = readHdrImage(o.input);
    if (!image) return complain(image.error());
    auto converted = convert(*image, o);
    if (!converted) return complain(converted.error());
    auto& [picture, about] = *converted;
    if (textOf(*image, "luxdeck:complete", "true") == "false") picture.text["luxdeck:complete"] = "false";
    if (context.progress.cancelled()) return Exit::Interrupted;
    if (const auto written = writePng(o.output, picture); !written) return complain(written.error());
    const auto told = writeOutput("-", describe(picture, about, o, context.common));
    return told ? Exit::Ok : complain(told.error());
}

}  // namespace

Command addTonemap(CLI::App& program) {
    const auto o = std::make_shared<Options>();
    auto* app = program.add_subcommand("tonemap", "A picture for people: histogram tone mapping as an eye or a camera would see it, or false colour with a legend");
    app->add_option("input", o->input, "Float picture in cd/m² or lx: .exr, .hdr, .pic")->required()->type_name("IN");
    app->add_option("-o,--output", o->output, "The picture")->required()->check(namedAs(".png"))->type_name("OUT.png");
    app->add_option("--operator", o->op, "human: what an eye there would see; camera: everything is recorded; linear: one exposure")
        ->check(CLI::IsMember({"human", "camera", "linear"}))->capture_default_str();
    app->add_option_function<double>("--exposure", [o](double e) { o->exposure = e; }, "Of --operator linear: display over world luminance; without it, the mean shows as 18 % grey")
        ->check(CLI::PositiveNumber);
    app->add_option("--white", o->white, "Luminance of the display's white, cd/m²")->check(CLI::PositiveNumber)->capture_default_str();
    app->add_option("--black", o->black, "Luminance of its black, cd/m²")->check(CLI::PositiveNumber)->capture_default_str();
    app->add_option("--view", o->ocioView, "OpenColorIO view; our config ($OCIO replaces it) has: Luxdeck (tone-mapped), ACES SDR, Raw")->type_name("NAME");
    app->add_flag("--no-veil", o->noVeil, "Leave out the light that scatters in the eye");
    app->add_flag("--no-acuity", o->noAcuity, "Leave out the blur of dim sight");
    app->add_flag("--no-colour-loss", o->noColourLoss, "Leave colours in the dark");
    app->add_flag("--no-white-balance", o->noWhiteBalance, "Do not adapt to the light sources' white");
    app->add_flag("--false-colour,--false-color", o->falseColour, "Numbers as colours, with a legend, instead of tone mapping");
    app->add_flag("--linear-scale", o->linear, "False colour and isolines in equal steps instead of equal ratios");
    app->add_option("--range", o->range, "Lowest and highest value of the false colours, in cd/m² or lx")->expected(2)->type_name("LOW HIGH");
    app->add_option("--map", o->map, "dusk (safe for colour blindness) or heat")->check(CLI::IsMember({"dusk", "heat"}))->capture_default_str();
    app->add_flag("--isolines", o->isolines, "Draw lines of equal value with their numbers");
    return {app, [o](Context& context) { return runTonemap(*o, context); }};
}

}  // namespace luxdeck::cli
