#include "cli/json_text.h"
#include "cli/volume_commands.h"
#include "engine/io/image_files.h"
#include "engine/volume/volume_diff.h"
#include "engine/volume/volume_file.h"
#include "engine/volume/volume_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace luxdeck::cli {

namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) && x >= 0 ? Json(x) : Json(nullptr); }

Exit print(const std::string& text) {
    const auto told = writeOutput("-", text);
    return told ? Exit::Ok : complain(told.error());
}

const char* samplingText(const VolumeSettings& s) {
    return s.sampling == BinSampling::Centres ? "at the centre of each bin" : "spread over the bin";
}

std::string infoText(const IrradianceVolume& v, const std::string& file) {
    const auto& s = v.settings;
    const auto box = v.lattice.bounds();
    const Vec3d low = Vec3d(box.min) + v.origin, high = Vec3d(box.max) + v.origin;
    double least = 1e300, most = 0, sum = 0, usable = 0;
    for (const auto& q : v.quality)
        if (q.usable()) least = std::min(least, q.meanLux()), most = std::max(most, q.meanLux()), sum += q.meanLux(), ++usable;
    std::string text = fmt::format("{}: irradiance volume of {}{}\n", file, v.scene.empty() ? "a scene" : v.scene, v.complete ? "" : " (incomplete)");
    text += fmt::format("  bounds        {:.3f} {:.3f} {:.3f} .. {:.3f} {:.3f} {:.3f} m\n", low.x, low.y, low.z, high.x, high.y, high.z);
    text += fmt::format("  vertices      {} ({} x {} x {} in the first level), {} unusable\n", v.vertexCount(), s.firstLevel[0], s.firstLevel[1], s.firstLevel[2], v.unusable());
    text += fmt::format("  cells         {}\n  directions    {} bins, {} samples each, {}; sources {}\n", v.lattice.cells().size(), v.binCount(), s.samplesPerBin, samplingText(s),
                        s.sources == SourceSampling::Sought ? "sought" : "met by chance");
    if (usable > 0) text += fmt::format("  illuminance   {:.4g} lx on average over six directions, {:.4g} .. {:.4g} lx\n", sum / usable, least, most);
    const double error = 1.96 * v.relativeError();
    text += std::isfinite(error) ? fmt::format("  error         ±{:.2g} % at the vertices (95 %, rms)", 100 * error) : std::string("  error         not known from one sample");
    if (v.interpolationError >= 0) text += fmt::format(", {:.2g} % between them", 100 * v.interpolationError);
    text += fmt::format("\n  made by       {}, seed {}, {:.1f} s, {:.3g} rays\n  memory        {:.1f} MB\n", v.algorithm, v.seed, v.seconds, static_cast<double>(v.rays),
                        static_cast<double>(v.bytes()) / 1e6);
    for (const auto& name : s.ignored) text += fmt::format("  ignored       {} ({:g} cd/m²)\n", name, s.ignoredCdM2);
    return text + fmt::format("  scene hash    {}\n", v.sceneHash);
}

std::string infoJson(const IrradianceVolume& v, const std::string& file) {
    const auto box = v.lattice.bounds();
    const Vec3d low = Vec3d(box.min) + v.origin, high = Vec3d(box.max) + v.origin;
    return jsonText({{"schema", "luxdeck-volume-info/1"}, {"file", file}, {"scene", v.scene}, {"sceneHash", v.sceneHash}, {"complete", v.complete},
                     {"bounds", {{"min", {low.x, low.y, low.z}}, {"max", {high.x, high.y, high.z}}}}, {"vertices", v.vertexCount()}, {"unusable", v.unusable()},
                     {"cells", v.lattice.cells().size()}, {"bins", v.binCount()}, {"bytes", v.bytes()}, {"error95", number(1.96 * v.relativeError())},
                     {"interpolationError", number(v.interpolationError)}, {"algorithm", v.algorithm}, {"seed", v.seed}, {"seconds", v.seconds}, {"rays", v.rays},
                     {"settings", Json::parse(settingsText(v.settings))}});
}

Json differenceJson(const FieldDifference& d) {
    return {{"rmsLux", d.rmsLux}, {"maxLux", d.maxLux}, {"rms", d.rms}, {"p99", d.p99}, {"max", d.max}, {"noise", number(d.noise)},
            {"meanFirst", d.meanFirst}, {"meanSecond", d.meanSecond}, {"vertices", d.vertices}};
}

std::string differenceText(const std::string& part, const FieldDifference& d) {
    return fmt::format("  {:<9} {:>9.4g} {:>9.4g} lx   {:>8.3g} lx {:>7.2f} %   {:>7.2f} %   {:>8.3g} lx {:>7.1f} %   {:>6.2f} %\n", part, d.meanFirst, d.meanSecond, d.rmsLux, 100 * d.rms,
                       100 * d.p99, d.maxLux, 100 * d.max, std::isfinite(d.noise) ? 100 * d.noise : std::nan(""));
}

struct DiffOptions {
    std::string first, second, output;
    int order = 1;
};

Exit runDiff(const DiffOptions& o, Context& context) {
    if (!o.output.empty())
        if (const auto possible = checkOutput(o.output); !possible) return complain(possible.error());
    const auto first = readVolume(o.first), second = readVolume(o.second);
    if (!first) return complain(first.error());
    if (!second) return complain(second.error());
    Json out{{"schema", "luxdeck-volume-diff/1"}, {"first", o.first}, {"second", o.second}, {"moment", o.order}, {"sameScene", first->sceneHash == second->sceneHash}};
    std::string text = fmt::format("{} ({}) against {} ({}), moment {}\n  {:<9} {:>9} {:>9}      {:>21}   {:>9}   {:>21}   {:>8}\n", o.first, first->algorithm, o.second,
                                   second->algorithm, o.order, "part", "first", "second", "rms", "99 %", "largest", "noise");
    const auto differences = compareVolumes(*first, *second, o.order);
    if (!differences) return complain(differences.error());
    for (const auto& [name, difference] : {std::pair{"total", &differences->total}, {"direct", &differences->direct}, {"indirect", &differences->indirect}})
        out[name] = differenceJson(*difference), text += differenceText(name, *difference);
    if (first->sceneHash != second->sceneHash) text += "The volumes are of different states of the scene.\n";
    if (!o.output.empty()) {
        const auto difference = volumeDifference(*first, *second);
        if (!difference) return complain(difference.error());
        if (const auto written = writeVolume(o.output, *difference); !written) return complain(written.error());
    }
    return print(context.common.json ? jsonText(out) : text);
}

struct ExportOptions {
    std::string volume, output;
    std::vector<double> at;
    int height = 256;
    FieldOptions field;
};

/// A table of the vertices, one a line.
std::string csvText(const VolumeField& field) {
    const auto& v = field.volume();
    std::string text = "x_m,y_m,z_m,usable,ci95_lx,facing_+x,facing_-x,facing_+y,facing_-y,facing_+z,facing_-z\n";
    for (std::uint32_t i = 0; i < v.vertexCount(); ++i) {
        const Vec3d p = Vec3d(v.lattice.vertices()[i]) + v.origin;
        text += fmt::format("{:.6g},{:.6g},{:.6g},{},{:.4g}", p.x, p.y, p.z, v.quality[i].usable() ? 1 : 0, 1.96 * v.quality[i].standardError());
        for (int axis = 0; axis < 6; ++axis) {
            Vec3 direction(0, 0, 0);
            direction[axis / 2] = axis % 2 == 0 ? 1.0F : -1.0F;
            text += fmt::format(",{:.6g}", luminance(field.atVertex(i, field.look(direction)), v.weights));
        }
        text += "\n";
    }
    return text;
}

/// What a point sees all around (moment 0), or throws on surfaces of any direction: a panorama by longitude and latitude, its
/// middle column facing +y, its upper edge +z.
Image panorama(const VolumeField& field, const Vec3& position, int height) {
    const int width = 2 * height;
    Image image(width, height, {"R", "G", "B"});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double latitude = kPiD * (0.5 - (y + 0.5) / height), longitude = 2 * kPiD * ((x + 0.5) / width - 0.5);
            const Vec3 d(Vec3d(std::cos(latitude) * std::sin(longitude), std::cos(latitude) * std::cos(longitude), std::sin(latitude)));
            const Rgb c = field.at(position, d);
            const auto i = image.index(x, y);
            image.channel("R")[i] = c.r, image.channel("G")[i] = c.g, image.channel("B")[i] = c.b;
        }
    const auto& v = field.volume();
    image.weights = v.weights;
    image.text["luxdeck:unit"] = field.settings().order == 0 ? "cd/m^2" : "lx";
    image.text["luxdeck:algorithm"] = v.algorithm, image.text["luxdeck:sceneHash"] = v.sceneHash;
    image.numbers["whiteLuminance"] = 1;
    return image;
}

Exit runExport(const ExportOptions& o) {
    if (const auto possible = checkOutput(o.output); !possible) return complain(possible.error());
    const auto volume = readVolume(o.volume);
    if (!volume) return complain(volume.error());
    const auto field = VolumeField::make(*volume, o.field.field());
    if (!field) return complain(field.error());
    const bool picture = CLI::detail::to_lower(std::filesystem::path(o.output).extension().string()) == ".exr";
    if (picture && o.at.empty()) return complain({ErrorCode::InvalidArgument, "a picture is of one point: --at X Y Z is missing", o.output});
    const auto written = picture ? writeExr(o.output, panorama(*field, Vec3(Vec3d(o.at[0], o.at[1], o.at[2]) - volume->origin), o.height))
                                 : writeOutput(o.output, csvText(*field));
    return written ? Exit::Ok : complain(written.error());
}

}  // namespace

Command addVolumeInfo(CLI::App& volume) {
    const auto file = std::make_shared<std::string>();
    auto* app = volume.add_subcommand("info", "What a volume holds: bounds in m, vertices, bins, illuminance in lx, error, how and in how many s it was made");
    app->add_option("volume", *file, "The volume")->required()->type_name("F.vtu");
    return {app, [file](Context& context) {
        const auto v = readVolume(*file);
        if (!v) return complain(v.error());
        return print(context.common.json ? infoJson(*v, *file) : infoText(*v, *file));
    }};
}

Command addVolumeDiff(CLI::App& volume) {
    const auto o = std::make_shared<DiffOptions>();
    auto* app = volume.add_subcommand("diff", "How far two volumes of the same grid lie apart, in lx and %, beside what their noise explains; total, direct and indirect light");
    app->add_option("first", o->first, "A volume")->required()->type_name("A.vtu");
    app->add_option("second", o->second, "Another")->required()->type_name("B.vtu");
    app->add_option("-o,--output", o->output, "The difference A - B as a volume, to be looked at")->check(namedAs(".vtu"))->type_name("F.vtu");
    app->add_option("--moment", o->order, "Order of the moment: 1 is irradiance")->check(CLI::Range(1, 1000000))->capture_default_str();
    return {app, [o](Context& context) { return runDiff(*o, context); }};
}

Command addVolumeExport(CLI::App& volume) {
    const auto o = std::make_shared<ExportOptions>();
    auto* app = volume.add_subcommand("export", "Of a volume: a table of its vertices (.csv, in lx), or a panorama of the light at a point (.exr, by longitude and latitude)");
    app->add_option("volume", o->volume, "The volume")->required()->type_name("F.vtu");
    app->add_option("-o,--output", o->output, "F.csv or F.exr; - is stdout, as CSV")->required()->type_name("FILE");
    app->add_option("--at", o->at, "The point of the panorama, in m")->expected(3)->type_name("X Y Z");
    app->add_option("--height", o->height, "Of the panorama in pixels; it is twice as wide")->check(CLI::Range(2, 8192))->capture_default_str();
    addFieldOptions(*app, o->field);
    return {app, [o](Context&) { return runExport(*o); }};
}

std::vector<Command> addVolume(CLI::App& program) {
    auto* volume = program.add_subcommand("volume", "Irradiance volumes: light at any point and direction of a scene, kept in a file (build, query, info, diff, export)");
    volume->require_subcommand(1);
    return {addVolumeBuild(*volume), addVolumeQuery(*volume), addVolumeInfo(*volume), addVolumeDiff(*volume), addVolumeExport(*volume)};
}

}  // namespace luxdeck::cli
