#include "analysis/furniture/shaded_file.h"
#include "analysis/furniture/stream_shade.h"
#include "cli/furniture_commands.h"
#include "cli/json_text.h"
#include "cli/streams.h"
#include "engine/core/file.h"
#include "engine/volume/volume_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::cli {

namespace {

struct Options {
    std::vector<std::string> scene;
    std::string volume, model, output;
    std::vector<double> at;
    double turnDeg = 0, metresPerUnit = 1, scaleLux = 1000;
    bool yUp = false, throughWalls = false;
};

Result<StreamCounts> shade(const Options& o, Context& context, const Loaded& loaded, const VolumeField& field) {
    auto stream = TriangleStream::open(o.model);
    if (!stream) return stream.error();
    StreamSettings settings;
    settings.metresPerUnit = o.metresPerUnit, settings.yUp = o.yUp, settings.turnDeg = o.turnDeg;
    settings.at = loaded.project.scene.toRebased(o.at.empty() ? Vec3d(0, 0, 0) : Vec3d(o.at[0], o.at[1], o.at[2]));
    const ShadedFile::Settings look{loaded.project.scene.origin, field.volume().weights, o.scaleLux};
    StreamCounts counts;
    const auto written = writeFileAtomically(o.output, [&](const std::filesystem::path& temporary) -> Result<void> {
        auto file = ShadedFile::create(temporary, lowerExtension(o.output), look);
        if (!file) return file.error();
        const auto sink = [&](std::span<const Vec3> positions, std::span<const Rgb> lux) { return file->vertices(positions, lux), Result<void>(); };
        auto done = shadeStream(**stream, field, o.throughWalls ? nullptr : &loaded.lit.raycaster(), settings, sink, context.progress);
        if (!done) return done.error();
        counts = *done;
        file->trianglesInOrder();
        return file->finish();
    });
    if (!written) return written.error();
    return counts;
}

Exit runShade(const Options& o, Context& context) {
    if (const auto possible = checkOutput(o.output); !possible) return complain(possible.error());
    auto loaded = load(o.scene, context.common.quiet);
    if (!loaded) return complain(loaded.error());
    const auto volume = readVolume(o.volume);
    if (!volume) return complain(volume.error());
    if (const auto fits = checkVolumeIsOf(*volume, (*loaded)->project.scene); !fits) return complain({fits.error().code, fits.error().message, o.volume});
    FieldSettings fieldSettings;
    fieldSettings.blendBins = true;
    const auto field = VolumeField::make(*volume, fieldSettings);
    if (!field) return complain(field.error());
    const auto counts = shade(o, context, **loaded, *field);
    if (!counts) return context.progress.cancelled() ? Exit::Interrupted : complain(counts.error());
    const auto& c = *counts;
    const double rate = c.shadingSeconds > 0 ? static_cast<double>(c.triangles) / c.shadingSeconds : 0;
    std::string text = context.common.json
        ? jsonText({{"schema", "luxdeck-shade/1"}, {"model", o.model}, {"output", o.output}, {"triangles", c.triangles}, {"skipped", c.skipped}, {"unknownVertices", c.unknown},
                    {"minimumLux", c.minimumLux}, {"maximumLux", c.maximumLux}, {"shadingSeconds", c.shadingSeconds}, {"trianglesPerSecond", rate}})
        : fmt::format("{}: {} triangles lit in {:.2g} s ({:.2g} million a second), {:.0f} to {:.0f} lx\n", o.output, c.triangles, c.shadingSeconds, 1e-6 * rate, c.minimumLux, c.maximumLux);
    if (c.skipped > 0) say(fmt::format("luxdeck: {} triangles without an area, or not finite, are left out\n", c.skipped));
    if (c.unknown > 0) say(fmt::format("luxdeck: {} vertices are seen by no vertex of the volume near them: nan (--through-walls takes what is behind walls)\n", c.unknown));
    if (const auto told = writeOutput("-", text); !told) return complain(told.error());
    return Exit::Ok;
}

}  // namespace

Command addShade(CLI::App& program) {
    const auto o = std::make_shared<Options>();
    auto* app = program.add_subcommand("shade", "Lights a model that is not in the scene from the scene's volume, whatever its size: its triangles are read, lit and written as they come, in lx");
    app->add_option("scene", o->scene, "The project or scene that the volume is of")->required()->type_name("PROJECT");
    app->add_option("--volume", o->volume, "The volume")->required()->type_name("F.vtu");
    app->add_option("--model", o->model, "Binary .stl, or .obj (v and f lines; a face may use the last 4 million vertices)")->required()->type_name("FILE");
    app->add_option("--at", o->at, "Where its origin goes, in m; 0 0 0 when not given")->expected(3)->type_name("X Y Z");
    app->add_option("--rotate", o->turnDeg, "Turned about the vertical through its origin, in degrees")->check(CLI::Range(-36000.0, 36000.0))->capture_default_str();
    app->add_option("--unit", o->metresPerUnit, "Its unit in m")->check(CLI::Range(1e-6, 1e6))->capture_default_str();
    app->add_flag("--y-up", o->yUp, "Its y points up");
    app->add_flag("--through-walls", o->throughWalls, "Plain trilinear interpolation: for a model that takes the place of a surface of the room");
    app->add_option("--scale", o->scaleLux, "Upper end of the colours, in lx")->check(CLI::Range(1e-6, 1e9))->capture_default_str();
    app->add_option("-o,--output", o->output, "Its vertices with their illuminance: .ply or .csv")->required()->check(namedAs(".ply") | namedAs(".csv"))->type_name("F.ply|F.csv");
    return {app, [o](Context& context) { return runShade(*o, context); }};
}

}  // namespace luxdeck::cli
