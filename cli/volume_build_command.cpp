#include "cli/furniture_commands.h"
#include "cli/json_text.h"
#include "cli/streams.h"
#include "cli/volume_commands.h"
#include "engine/algorithms/registry.h"
#include "engine/volume/vertex_journal.h"
#include "engine/volume/volume_build.h"
#include "engine/volume/volume_file.h"
#include "engine/volume/volume_pictures.h"
#include "engine/volume/volume_update.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck::cli {

namespace {

struct Options {
    std::vector<std::string> scene;
    std::string output, name, pictures, update;
    std::vector<int> grid;
    std::vector<double> bounds;
    std::optional<int> secondLevel, bins;
    int depth = 4;
    double refine = 0;
    bool thesis = false;
    std::vector<std::string> ignored, without;
    double ignoredCdM2 = 0;
    Effort effort;
};

Result<VolumeSettings> settingsOf(const Options& o, const Project& project) {
    const auto own = volumeSettingsOf(project, o.name);
    if (!own) return own;
    auto s = *own;
    const auto& b = o.bounds;
    if (!b.empty()) s.bounds = Box3(project.scene.toRebased({b[0], b[1], b[2]}), project.scene.toRebased({b[3], b[4], b[5]}));
    if (!o.grid.empty()) s.firstLevel = {o.grid[0], o.grid[1], o.grid[2]};
    s.secondLevel = o.secondLevel.value_or(s.secondLevel), s.side = o.bins.value_or(s.side);
    s.refineBelow = o.refine, s.refineDepth = o.depth;
    s.ignored = o.ignored, s.ignoredCdM2 = static_cast<float>(o.ignoredCdM2);
    if (o.thesis) s.sampling = BinSampling::Centres, s.sources = SourceSampling::InBins, s.samplesPerBin = 1;
    if (o.effort.samples) s.samplesPerBin = *o.effort.samples;
    return s;
}

std::string describe(const IrradianceVolume& v, const std::string& output, bool json, bool reached) {
    const double error = 1.96 * v.relativeError();
    const auto known = [](double x) { return std::isfinite(x) && x >= 0 ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr); };
    if (json)
        return jsonText({{"schema", "luxdeck-volume-build/1"}, {"output", output}, {"complete", v.complete}, {"seconds", v.seconds}, {"rays", v.rays},
                         {"vertices", v.vertexCount()}, {"unusable", v.unusable()}, {"cells", v.lattice.cells().size()}, {"bins", v.binCount()},
                         {"bytes", v.bytes()}, {"error95", known(error)}, {"interpolationError", known(v.interpolationError)}, {"targetReached", reached},
                         {"algorithm", v.algorithm}, {"seed", v.seed}});
    std::string text = fmt::format("{}: {} vertices ({} inside solids), {} bins, {:.1f} MB, {:.1f} s\n", output, v.vertexCount(), v.unusable(), v.binCount(),
                                   static_cast<double>(v.bytes()) / 1e6, v.seconds);
    text += std::isfinite(error) ? fmt::format("Irradiance at the vertices is known to ±{:.2g} % (95 %, rms)", 100 * error)
                                 : std::string("The error at the vertices is not known from one sample of each bin");
    if (v.interpolationError >= 0) text += fmt::format("; between them interpolation was {:.2g} % off (rms, where cells were divided)", 100 * v.interpolationError);
    return text + (v.complete ? ".\n" : ". Incomplete: interrupted or out of time; the same command goes on where it stopped.\n");
}

Exit tell(const IrradianceVolume& volume, const Options& o, const Context& context, bool reached) {
    const auto told = writeOutput("-", describe(volume, o.output, context.common.json, reached));
    return told ? Exit::Ok : complain(told.error());
}

Exit buildFromPictures(const Options& o, Context& context) {
    const auto nodes = readPanoramaNodes(o.pictures);
    if (!nodes) return complain(nodes.error());
    const auto volume = buildVolumeFromPictures(*nodes, o.bins.value_or(17), context.progress);
    if (!volume) return complain(volume.error());
    if (const auto written = writeVolume(o.output, *volume); !written) return complain(written.error());
    return tell(*volume, o, context, true);
}

/// Whether an old volume's vertices are what this build would make of them.
Result<void> sameBuild(const IrradianceVolume& old, const Options& o, const Context& context, const VolumeSettings& settings) {
    const auto was = buildIdentity("", old.algorithm, old.seed, old.settings), wanted = buildIdentity("", o.effort.algorithm, context.common.seed, settings);
    if (was == wanted) return {};
    return Error{ErrorCode::InvalidArgument, fmt::format("was built otherwise ({}), expected {}", was, wanted), o.update};
}

void tellOfUpdate(const VolumeUpdate& update, const IrradianceVolume& volume, const VertexSampler& sampler) {
    std::string what;
    for (const auto& change : update.changes()) what += (what.empty() ? "" : ", ") + change;
    const auto off = update.measureKept(volume, sampler);
    say(fmt::format("luxdeck: {}: {} of {} vertices see nothing of it and were kept{}\n", what.empty() ? "nothing changed" : what, update.kept(), volume.vertexCount(),
                    off.vertices > 0 ? fmt::format("; {} of them looked at again were {:.2g} % off (rms)", off.vertices, 100 * off.relative) : std::string()));
}

Exit buildFromScene(const Options& o, Context& context) {
    auto loaded = load(o.scene, context.common.quiet);
    if (!loaded) return complain(loaded.error());
    for (const auto& name : o.without)
        if (const auto removed = removeObject(**loaded, name); !removed) return complain(removed.error());
    const auto& lit = (*loaded)->lit;
    const auto wanted = settingsOf(o, (*loaded)->project);
    if (!wanted) return complain(wanted.error());
    const auto& settings = *wanted;
    const auto hash = sceneHash((*loaded)->project.scene);
    auto estimator = makeEstimator(o.effort.algorithm, lit.transport(), o.effort.settings(), context.common.seed, context.progress);
    if (!estimator) return complain(estimator.error());
    auto journal = VertexJournal::open(o.output + ".part", buildIdentity(hash, o.effort.algorithm, context.common.seed, settings));
    if (!journal) return complain(journal.error());
    if ((*journal)->found() > 0 && !context.common.quiet) say(fmt::format("luxdeck: {} vertices are known from an earlier session\n", (*journal)->found()));
    std::optional<IrradianceVolume> old;
    std::unique_ptr<VolumeUpdate> updating;
    if (!o.update.empty()) {
        auto read = readVolume(o.update);
        if (!read) return complain(read.error());
        old.emplace(*std::move(read));
        if (const auto same = sameBuild(*old, o, context, settings); !same) return complain(same.error());
        updating = std::make_unique<VolumeUpdate>(*old, lit.transport(), journal->get());
    }
    BuildOptions options;
    options.algorithm = o.effort.algorithm, options.seed = context.common.seed;
    options.targetError = o.effort.targetError.value_or(0), options.timeSeconds = o.effort.timeSeconds;
    options.store = updating ? static_cast<VertexStore*>(updating.get()) : journal->get();
    const auto volume = buildVolume(lit.transport(), **estimator, settings, options, context.progress);
    if (!volume) return complain(volume.error());
    if (const auto written = writeVolume(o.output, *volume); !written) return complain(written.error());
    if (volume->complete) (*journal)->remove();
    if (updating && !context.common.quiet) tellOfUpdate(*updating, *volume, VertexSampler::create(lit.transport(), **estimator, settings, context.common.seed).value());
    const bool reached = volume->complete && (options.targetError == 0 || 1.96 * volume->relativeError() <= options.targetError);
    if (const auto exit = tell(*volume, o, context, reached); exit != Exit::Ok) return exit;
    return context.progress.cancelled() ? Exit::Interrupted : reached ? Exit::Ok : Exit::NotReached;
}

Exit runBuild(const Options& o, Context& context) {
    if (const auto possible = checkOutput(o.output); !possible) return complain(possible.error());
    if (o.pictures.empty() == o.scene.empty()) {
        say("luxdeck: a volume is built from a project or scene, or with --pictures from pictures: expected one of them\n");
        return Exit::Usage;
    }
    return o.pictures.empty() ? buildFromScene(o, context) : buildFromPictures(o, context);
}

}  // namespace

Command addVolumeBuild(CLI::App& volume) {
    const auto o = std::make_shared<Options>();
    auto* app = volume.add_subcommand("build", "Build an irradiance volume: the light at any point in any direction, in a .vtu file that ParaView opens. "
        "Interrupted or killed, the same command goes on where it stopped (what is finished lies in F.vtu.part)");
    app->add_option("scene", o->scene, "project.toml or a scene file; several .rad and .mat files are one scene, in their order")->type_name("PROJECT");
    app->add_option("--pictures", o->pictures, "Build from panoramas instead: a TOML file of nodes, each with its position in m and an EXR or HDR by longitude and latitude")->type_name("FILE");
    app->add_option("-o,--output", o->output, "The volume")->required()->check(namedAs(".vtu"))->type_name("F.vtu");
    app->add_option("--name", o->name, "Which [[volume]] of the project; the first when not given")->type_name("NAME");
    app->add_option("--update", o->update, "A volume of an earlier state of the scene, built with the same settings: vertices that see nothing of objects that moved are kept")->type_name("OLD.vtu");
    app->add_option("--grid", o->grid, "Vertices along x, y and z in the first level; 7 7 7 where neither project nor this says so")->expected(3)->check(CLI::Range(2, 1025))->type_name("X Y Z");
    app->add_option("--bounds", o->bounds, "Lower and upper corner of the first level in m; those of the project's [[volume]], else the scene's drawn in by 2 cm")
        ->expected(6)->type_name("X0 Y0 Z0 X1 Y1 Z1");
    app->add_option("--second-level", o->secondLevel, "Vertices along each side of a cell that holds geometry; 1: it is not divided; else 3")
        ->check(CLI::Range(1, 32));
    app->add_option_function<std::string>("--refine", [o](const std::string& text) {
        if (const auto wrong = parsePercent(text, o->refine); !wrong.empty()) throw CLI::ValidationError("--refine", wrong);
    }, "Divide cells into eight instead, while their vertices differ by more than this in the illuminance along an axis: 20%")->type_name("P");
    app->add_option("--depth", o->depth, "With --refine: at most that often")->check(CLI::Range(1, 8))->capture_default_str();
    app->add_option("--bins", o->bins, "Directional bins along a hemisphere's side, 2 N^2 in all; else 17")->check(CLI::Range(2, 64));
    app->add_flag("--thesis", o->thesis, "As Greger 1996 did it: one ray through the centre of each bin, sources met by chance. The baseline for comparisons");
    app->add_option("--without", o->without, "Leave this object out of the scene: the volume that `furniture --object` lights it from, wherever it is moved")->type_name("OBJECT");
    app->add_option("--ignore", o->ignored, "Object whose light is left out where a ray meets it first: shows what it does to the flow of light")->type_name("OBJECT");
    app->add_option("--ignored-luminance", o->ignoredCdM2, "Luminance that ignored objects have instead, in cd/m²")->check(CLI::Range(0.0, 1e9))->capture_default_str();
    addEffort(*app, o->effort);
    app->get_option("--samples")->description("Samples of each bin at each vertex; 4 when not given");
    app->get_option("--target-error")->description("Double the samples until the irradiance at the vertices is known to this (95 %, rms): 2%, 0.02");
    return {app, [o](Context& context) { return runBuild(*o, context); }};
}

}  // namespace luxdeck::cli
