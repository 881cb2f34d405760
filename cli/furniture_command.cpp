#include "analysis/furniture/shaded_file.h"
#include "analysis/furniture/taken_light.h"
#include "cli/furniture_commands.h"
#include "cli/json_text.h"
#include "cli/streams.h"
#include "engine/algorithms/registry.h"
#include "engine/core/file.h"
#include "engine/core/stopwatch.h"
#include "engine/io/scene_files.h"
#include "engine/volume/volume_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::vector<std::string> scene;
    std::string volume, object, model, output;
    std::vector<double> move, at;
    double turnDeg = 0, metresPerUnit = 1, edgeM = 0.1, scaleLux = 0;
    std::optional<double> required, limit;
    std::size_t fullVertices = 0;
    bool exact = false, throughWalls = false;
    Effort effort;
};

/// The room without the object, the object, and where it stands.
struct Setting {
    std::unique_ptr<Loaded> room;
    Scene source;                        // that the object is of: the whole project's, or a model's
    std::optional<MovableObject> object;
    Pose pose;
    IrradianceVolume volume;
};

/// All that was found out.
struct Findings {
    WorkingSurfaceLight surface;
    double updateSeconds = 0;
    std::vector<GridTaken> grids;
    std::optional<ExactTaken> exact;
    std::optional<FullSolution> full;
};

Result<void> takeModel(const Options& o, Setting& s) {
    GeometryPlacement placement;
    placement.metresPerUnit = o.metresPerUnit;
    auto part = readSceneFile(o.model, placement);
    if (!part) return part.error();
    s.source = std::move(part->scene);
    if (const auto good = validate(s.source); !good) return Error{good.error().code, good.error().message, o.model};
    auto object = makeMovableObject(s.source, {.longestEdgeM = o.edgeM});
    if (!object) return Error{object.error().code, object.error().message, o.model};
    s.object = *std::move(object);
    // Its pivot, in the room's coordinates, stands where it does in the file unless told otherwise.
    const Vec3d stands = o.at.empty() ? s.source.origin + s.object->pivot : Vec3d(o.at[0], o.at[1], o.at[2]);
    s.pose.moveM = stands - s.room->project.scene.origin - s.object->pivot;
    return {};
}

Result<void> takeObject(const Options& o, Setting& s) {
    s.source = s.room->project.scene;
    auto object = makeMovableObject(s.source, o.object, {.longestEdgeM = o.edgeM});
    if (!object) return object.error();
    const auto found = std::find_if(s.source.objects.begin(), s.source.objects.end(), [&](const auto& each) { return each.name == o.object; });
    if (!found->movable)
        return Error{ErrorCode::InvalidArgument, fmt::format("object \"{}\" is not movable: a [[furniture]] table with object = \"{}\" makes it so (docs/project-format.md)", o.object, o.object), {}};
    s.object = *std::move(object);
    if (!o.at.empty()) s.pose.moveM = Vec3d(o.at[0], o.at[1], o.at[2]) - s.source.origin - s.object->pivot;
    return removeObject(*s.room, o.object);
}

Result<Setting> prepare(const Options& o, bool quiet) {
    Setting s;
    auto loaded = load(o.scene, quiet);
    if (!loaded) return loaded.error();
    s.room = *std::move(loaded);
    if (const auto taken = o.model.empty() ? takeObject(o, s) : takeModel(o, s); !taken) return taken.error();
    if (!o.move.empty()) s.pose.moveM += Vec3d(o.move[0], o.move[1], o.move[2]);
    s.pose.turnDeg = o.turnDeg;
    printWarnings(s.object->warnings, quiet);
    auto volume = readVolume(o.volume);
    if (!volume) return volume.error();
    if (const auto fits = checkVolumeIsOf(*volume, s.room->project.scene); !fits) {
        const auto how = o.model.empty() ? fmt::format("; the volume must be of the scene without the object: luxdeck volume build {} --without \"{}\" -o {}", o.scene.front(), o.object, o.volume) : "";
        return Error{fits.error().code, fits.error().message + how, o.volume};
    }
    s.volume = *std::move(volume);
    return s;
}

Result<void> solveExactly(const Options& o, Context& context, const Setting& s, const FurnitureLighting& lighting, Findings& found) {
    if (!o.exact && o.fullVertices == 0) return {};
    const auto& room = *s.room;
    const Scene furnished = withObjectAt(room.project.scene, s.source, o.model.empty() ? o.object : "", *s.object, s.pose);
    if (o.exact) {
        SolveSettings settings;
        settings.algorithm = o.effort.algorithm, settings.algorithmSettings = o.effort.settings(), settings.seed = context.common.seed;
        settings.timeSeconds = o.effort.timeSeconds, settings.samples = o.effort.samples;
        settings.targetError = o.effort.targetError.value_or(o.effort.timeSeconds ? 0.0 : 0.02);
        auto exact = solveTaken(room.project, room.lit, furnished, settings, context.progress);
        if (!exact) return exact.error();
        found.exact = *std::move(exact);
    }
    if (o.fullVertices > 0) {
        const auto lit = LitScene::create(furnished);
        if (!lit) return lit.error();
        const auto estimator = makeEstimator(o.effort.algorithm, lit->transport(), o.effort.settings());
        if (!estimator) return estimator.error();
        found.full = solveVertices(*lit, **estimator, lighting, o.fullVertices, o.effort.samples.value_or(1024), context.common.seed, context.progress);
    }
    return {};
}

Result<void> writeShaded(const Options& o, const Setting& s, const FurnitureLighting& lighting, const WorkingSurfaceLight& surface) {
    if (o.output.empty()) return {};
    ShadedFile::Settings settings;
    settings.origin = s.room->project.scene.origin, settings.weights = s.volume.weights;
    settings.scaleLux = o.scaleLux > 0 ? o.scaleLux : std::max(1.0, surface.maximum.value);
    return writeFileAtomically(o.output, [&](const std::filesystem::path& temporary) -> Result<void> {
        auto file = ShadedFile::create(temporary, lowerExtension(o.output), settings);
        if (!file) return file.error();
        std::vector<Vec3> positions;
        for (const auto& p : s.object->positions) positions.push_back(lighting.placement().point(p));
        file->vertices(positions, lighting.lux());
        file->triangles(s.object->triangles);
        return file->finish();
    });
}

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
Json interval(const Interval& i) { return {{"value", number(i.value)}, {"ci95", number(i.ci95)}}; }
Json optional(const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); }

Json point(const Interval& i, const Vec3d& at) {
    auto out = interval(i);
    out["at"] = {at.x, at.y, at.z};
    return out;
}

std::string asJson(const Options& o, const Setting& s, const Findings& f) {
    const auto& scene = s.room->project.scene;
    const Vec3d stands = s.object->pivot + s.pose.moveM + scene.origin;
    Json out{{"schema", "luxdeck-furniture/1"}, {"object", s.object->name}, {"at", {stands.x, stands.y, stands.z}}, {"turnDeg", s.pose.turnDeg},
             {"vertices", s.object->positions.size()}, {"triangles", s.object->triangles.size()}, {"updateSeconds", f.updateSeconds}};
    const bool known = f.surface.unknownPart < 1;
    out["workingSurface"] = {{"areaM2", s.object->workingSurfaceM2}, {"unknownPart", f.surface.unknownPart},
                             {"mean", known ? interval(f.surface.mean) : Json(nullptr)},
                             {"minimum", known ? point(f.surface.minimum, scene.toUser(f.surface.minimumAt)) : Json(nullptr)},
                             {"maximum", known ? point(f.surface.maximum, scene.toUser(f.surface.maximumAt)) : Json(nullptr)}};
    out["required"] = optional(o.required), out["limit"] = optional(o.limit), out["verdict"] = verdictText(f.surface.verdict);
    out["grids"] = Json::array();
    for (std::size_t i = 0; i < f.grids.size(); ++i) {
        const auto& g = f.grids[i];
        Json grid{{"name", g.name}, {"empty", g.mean.empty}, {"direct", g.mean.direct}, {"indirect", g.mean.indirect}, {"returned", g.mean.returned},
                  {"furnished", g.mean.furnished()}, {"taken", g.mean.taken()}, {"mostTaken", g.points[g.most].taken()}, {"mostTakenPoint", g.most}, {"unknown", g.unknown}, {"exact", nullptr}};
        if (f.exact)
            grid["exact"] = {{"empty", interval(f.exact->grids[i].emptyMean.interval)}, {"furnished", interval(f.exact->grids[i].furnishedMean.interval)}, {"taken", interval(f.exact->grids[i].takenMean)}};
        out["grids"].push_back(std::move(grid));
    }
    out["full"] = nullptr;
    if (f.full)
        out["full"] = {{"vertices", f.full->vertices.size()}, {"rms", f.full->rms}, {"relativeRms", f.full->relativeRms}, {"bias", f.full->bias}, {"insideInterval", f.full->inside}};
    out["output"] = o.output.empty() ? Json(nullptr) : Json(o.output);
    return jsonText(out);
}

std::string asText(const Setting& s, const Findings& f) {
    const auto& scene = s.room->project.scene;
    const auto place = [&](const Vec3& p) { const auto u = scene.toUser(p); return fmt::format("at {:.2f} {:.2f} {:.2f}", u.x, u.y, u.z); };
    const Vec3d stands = s.object->pivot + s.pose.moveM + scene.origin;
    std::string text = fmt::format("{} at {:.2f} {:.2f} {:.2f}, turned {:g}°: {} vertices lit in {:.2g} ms\n", s.object->name, stands.x, stands.y, stands.z, s.pose.turnDeg,
                                   s.object->positions.size(), 1e3 * f.updateSeconds);
    if (s.object->workingSurfaceM2 == 0) text += "  no working surface: nothing of it faces up\n";
    else if (f.surface.unknownPart == 1) text += "  nothing is known of its working surface: it lies in a wall, or where no vertex of the volume sees it\n";
    else
        text += fmt::format("  working surface, {:.2f} m²: mean {:.0f} ± {:.0f} lx, min {:.0f} ± {:.0f} lx {}, max {:.0f} ± {:.0f} lx {}\n", s.object->workingSurfaceM2,
                            f.surface.mean.value, f.surface.mean.ci95, f.surface.minimum.value, f.surface.minimum.ci95, place(f.surface.minimumAt),
                            f.surface.maximum.value, f.surface.maximum.ci95, place(f.surface.maximumAt));
    if (f.surface.unknownPart > 0 && f.surface.unknownPart < 1) text += fmt::format("  {:.0f} % of it are not known\n", 100 * f.surface.unknownPart);
    if (f.surface.verdict != FurnitureVerdict::None) text += fmt::format("  {}\n", verdictText(f.surface.verdict));
    if (!f.grids.empty()) text += "What it takes from the grids' means, in lx (first order):\n";
    for (std::size_t i = 0; i < f.grids.size(); ++i) {
        const auto& g = f.grids[i];
        text += fmt::format("  {:<32} {:8.1f} of {:.0f} (direct {:.1f}, indirect {:.1f}, returned {:.1f})", g.name, g.mean.taken(), g.mean.empty, g.mean.direct, g.mean.indirect, g.mean.returned);
        if (f.exact) {
            const auto& e = f.exact->grids[i];
            text += fmt::format("; solved: {:.1f} ± {:.1f} of {:.0f}", e.takenMean.value, e.takenMean.ci95, e.emptyMean.interval.value);
        }
        text += "\n";
    }
    if (f.full)
        text += fmt::format("Against a full solution at {} vertices: rms {:.1f} lx ({:.1f} %), bias {:+.1f} lx, {:.0f} % within their intervals\n", f.full->vertices.size(), f.full->rms,
                            100 * f.full->relativeRms, f.full->bias, 100 * f.full->inside);
    return text;
}

Exit runFurniture(const Options& o, Context& context) {
    if (!o.output.empty())
        if (const auto possible = checkOutput(o.output); !possible) return complain(possible.error());
    const auto prepared = prepare(o, context.common.quiet);
    if (!prepared) return complain(prepared.error());
    const auto& s = *prepared;
    const auto lighting = FurnitureLighting::create(*s.object, s.volume, o.throughWalls ? nullptr : &s.room->lit.raycaster());
    if (!lighting) return complain(lighting.error());
    Findings found;
    const Stopwatch clock;
    (*lighting)->update(s.pose);
    found.surface = (*lighting)->workingSurface({o.required, o.limit});
    found.updateSeconds = clock.seconds();
    auto grids = estimateTaken(s.room->project, s.room->lit, **lighting, {.seed = context.common.seed});
    if (!grids) return complain(grids.error());
    found.grids = *std::move(grids);
    if (const auto solved = solveExactly(o, context, s, **lighting, found); !solved) return complain(solved.error());
    if (const auto written = writeShaded(o, s, **lighting, found.surface); !written) return complain(written.error());
    if (const auto told = writeOutput("-", context.common.json ? asJson(o, s, found) : asText(s, found)); !told) return complain(told.error());
    if (context.progress.cancelled()) return Exit::Interrupted;
    const auto verdict = found.surface.verdict;
    if (verdict == FurnitureVerdict::Under || verdict == FurnitureVerdict::Over) return Exit::NotMet;
    return found.exact && !(found.exact->empty.targetReached && found.exact->furnished.targetReached) ? Exit::NotReached : Exit::Ok;
}

}  // namespace

Result<void> removeObject(Loaded& loaded, const std::string& name) {
    auto rest = withoutObject(loaded.project.scene, name);
    if (!rest) return rest.error();
    loaded.project.scene = *std::move(rest);
    auto lit = LitScene::create(loaded.project.scene);
    if (!lit) return lit.error();
    loaded.lit = *std::move(lit);
    return {};
}

Command addFurniture(CLI::App& program) {
    const auto o = std::make_shared<Options>();
    auto* app = program.add_subcommand("furniture", "A movable object lit from the volume of the room without it: illuminance of its working surface in lx against a requirement, and what it takes "
        "from the room's grids. `volume build --without OBJECT` makes the volume");
    app->add_option("scene", o->scene, "project.toml or a scene file; several .rad and .mat files are one scene, in their order")->required()->type_name("PROJECT");
    app->add_option("--volume", o->volume, "The volume: of the scene without the object, or, with --model, of the scene as it is")->required()->type_name("F.vtu");
    auto* object = app->add_option("--object", o->object, "One of the project's movable objects")->type_name("NAME");
    auto* model = app->add_option("--model", o->model, "A .glb, .gltf or .obj file instead")->excludes(object)->type_name("FILE");
    app->add_option("--unit", o->metresPerUnit, "With --model: its unit in m (glTF is always in m)")->check(CLI::Range(1e-6, 1e6))->needs(model)->capture_default_str();
    app->add_option("--at", o->at, "Where the centre of its foot goes, in m; where it stands when not given")->expected(3)->type_name("X Y Z");
    app->add_option("--move", o->move, "How far it is moved from there, in m")->expected(3)->type_name("DX DY DZ");
    app->add_option("--rotate", o->turnDeg, "Turned about the vertical through the centre of its foot, in degrees, counter-clockwise from above")->check(CLI::Range(-36000.0, 36000.0))->capture_default_str();
    app->add_option("--required", o->required, "Mean illuminance that its working surface needs, in lx")->check(CLI::Range(0.0, 1e9))->type_name("LX");
    app->add_option("--limit", o->limit, "Illuminance that it must not have anywhere, in lx")->check(CLI::Range(0.0, 1e9))->type_name("LX");
    app->add_option("--edge", o->edgeM, "Triangles are divided until no edge is longer, in m")->check(CLI::Range(1e-4, 1e3))->capture_default_str();
    app->add_flag("--through-walls", o->throughWalls, "Plain trilinear interpolation, which knows of no walls (the thesis' way)");
    app->add_flag("--exact", o->exact, "Solve the grids without and with the object, too");
    app->add_option("--full", o->fullVertices, "Solve so many of its vertices in the furnished room, too (1024 paths each, or --samples), and tell how far the volume is off")
        ->check(CLI::Range(1, 1000000))->type_name("N");
    app->add_option("--scale", o->scaleLux, "Upper end of the colours of the output, in lx; the working surface's maximum when not given")->check(CLI::Range(0.0, 1e9))->type_name("LX");
    app->add_option("-o,--output", o->output, "Its vertices with their illuminance: .ply or .csv")->check(namedAs(".ply") | namedAs(".csv"))->type_name("F.ply|F.csv");
    addEffort(*app, o->effort);
    app->final_callback([o] {
        if (o->object.empty() && o->model.empty()) throw CLI::RequiredError("--object or --model");
    });
    return {app, [o](Context& context) { return runFurniture(*o, context); }};
}

}  // namespace luxdeck::cli
