#include "cli/command.h"
#include "cli/json_text.h"
#include "cli/load.h"
#include "engine/io/photometry.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace luxdeck::cli {

namespace {

using Json = nlohmann::ordered_json;

const char* symmetryText(PhotometrySymmetry s) {
    switch (s) {
        case PhotometrySymmetry::None: return "none";
        case PhotometrySymmetry::Axial: return "axial";
        case PhotometrySymmetry::Bilateral0to180: return "about C0-C180";
        case PhotometrySymmetry::Bilateral90to270: return "about C90-C270";
        case PhotometrySymmetry::Quadrant: return "about both planes";
    }
    return "";
}

const char* openingText(OpeningShape s) {
    switch (s) {
        case OpeningShape::Point: return "point";
        case OpeningShape::Rectangle: return "rectangle";
        case OpeningShape::Disc: return "disc";
        case OpeningShape::Box: return "box";
        case OpeningShape::Cylinder: return "cylinder";
        case OpeningShape::Sphere: return "sphere";
    }
    return "";
}

const char* typeText(PhotometryType t) { return t == PhotometryType::C ? "C" : t == PhotometryType::B ? "B" : "A"; }

Json photometryJson(const Photometry& p) {
    const auto& t = p.table;
    return {{"schema", "luxdeck-check/1"}, {"name", p.name}, {"manufacturer", p.manufacturer}, {"lamp", p.lamp}, {"format", p.format},
            {"photometry", fmt::format("type {}{}", typeText(t.type()), p.absolute ? ", absolute" : ", relative")},
            {"lumensDeclared", p.lumensDeclared}, {"lumensIntegrated", t.lumens()}, {"lumensDown", t.lumensDown()},
            {"maxCandela", t.maxIntensity()}, {"symmetry", symmetryText(p.symmetry)},
            {"opening", {{"shape", openingText(p.opening.shape)}, {"length", p.opening.lengthM}, {"width", p.opening.widthM}, {"height", p.opening.heightM}}},
            {"angles", {{"vertical", t.vertical().size()}, {"horizontal", t.horizontal().size()}}}, {"watts", p.watts},
            {"fileHash", p.fileHash}, {"repairs", p.repairs}, {"warnings", p.warnings}};
}

std::string photometryText(const Photometry& p) {
    const auto& t = p.table;
    std::string text = fmt::format("{}{}\n  photometry  {}, type {}, {}, symmetry {}\n  angles      {} vertical, {} horizontal\n", p.name.empty() ? "luminaire without a name" : p.name, p.manufacturer.empty() ? "" : "  (" + p.manufacturer + ")",
                                   p.format, typeText(t.type()), p.absolute ? "absolute" : "relative", symmetryText(p.symmetry),
                                   t.vertical().size(), t.horizontal().size());
    text += fmt::format("  lumens      {:.1f} integrated, {} declared\n  candela     {:.1f} at most\n  opening     {} {:.3f} x {:.3f} x {:.3f} m (length along C0-C180)\n", t.lumens(),
                        p.lumensDeclared > 0 ? fmt::format("{:.1f}", p.lumensDeclared) : "none", t.maxIntensity(), openingText(p.opening.shape),
                        p.opening.lengthM, p.opening.widthM, p.opening.heightM);
    if (p.watts > 0) text += fmt::format("  power       {:.1f} W, {:.0f} lm/W\n", p.watts, t.lumens() / p.watts);
    for (const auto& r : p.repairs) text += "  repaired: " + r + "\n";
    for (const auto& w : p.warnings) text += "  warning: " + w + "\n";
    return text;
}

Json needsJson(const SceneNeeds& n) {
    return {{"specularChains", n.specularChains}, {"transmission", n.transmission}, {"glossy", n.glossy}, {"textures", n.textures},
            {"smoothNormals", n.smoothNormals}, {"sky", n.sky}, {"meshLights", n.meshLights}, {"luminaireSurfaces", n.luminaireSurfaces},
            {"manyLights", n.manyLights}, {"colour", n.colour}, {"rebasing", n.rebasing}};
}

double totalLumens(const Scene& scene) {
    double sum = 0;
    for (const auto& l : scene.luminaires) sum += scene.luminaireTypes[l.type].photometry.table.lumens() * l.outputScale();
    return sum;
}

Json projectJson(const Loaded& l) {
    const auto& s = l.project.scene;
    const auto box = s.bounds();
    Json out{{"schema", "luxdeck-check/1"}, {"project", l.project.info.name}, {"triangles", s.triangleCount()}, {"objects", s.objects.size()},
             {"luminaires", s.luminaires.size()}, {"lumens", totalLumens(s)}, {"materials", s.materials.size()}, {"textures", s.textures.size()}};
    if (box.isEmpty()) out["bounds"] = nullptr;
    else {
        const auto low = s.toUser(box.min), high = s.toUser(box.max);
        out["bounds"] = {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
    }
    out["grids"] = l.project.grids.size(), out["views"] = l.project.views.size();
    out["volumes"] = l.project.volumes.size(), out["holodeckSections"] = l.project.holodeckSections.size();
    out["needs"] = needsJson(l.lit.needs());
    out["leftOut"] = Json::array();
    for (const auto& x : leftOut(l.lit.needs())) out["leftOut"].push_back({{"what", x.what}, {"why", x.why}});
    out["warnings"] = s.warnings;
    out["sceneHash"] = s.hash, out["kernel"] = l.lit.raycaster().kernel();
    out["accelerationBytes"] = l.lit.raycaster().bytes(), out["setupSeconds"] = l.seconds;
    return out;
}

std::string projectText(const Loaded& l) {
    const auto& s = l.project.scene;
    const auto box = s.bounds();
    std::string text = fmt::format("{}\n  geometry    {} triangles in {} objects, {} materials, {} textures\n", l.project.info.name, s.triangleCount(),
                                   s.objects.size(), s.materials.size(), s.textures.size());
    if (!box.isEmpty()) {
        const auto low = s.toUser(box.min), high = s.toUser(box.max);
        text += fmt::format("  bounds      {:.2f} {:.2f} {:.2f} to {:.2f} {:.2f} {:.2f} m\n", low.x, low.y, low.z, high.x, high.y, high.z);
    }
    text += fmt::format("  luminaires  {} of {} types, {:.0f} lm in use\n", s.luminaires.size(), s.luminaireTypes.size(), totalLumens(s));
    text += fmt::format("  asked for   {} calculation grids, {} views, {} volumes, {} holodeck sections\n", l.project.grids.size(), l.project.views.size(),
                        l.project.volumes.size(), l.project.holodeckSections.size());
    text += fmt::format("  ready in    {:.2f} s, {:.1f} MB for {}\n", l.seconds, static_cast<double>(l.lit.raycaster().bytes()) * 1e-6, l.lit.raycaster().kernel());
    const auto left = leftOut(l.lit.needs());
    text += left.empty() ? "  left out    nothing: the scene needs everything\n" : "  left out, as the scene does not need it:\n";
    for (const auto& x : left) text += fmt::format("              {} ({})\n", x.what, x.why);
    return text;
}

bool isPhotometric(const std::filesystem::path& path) {
    auto extension = path.extension().string();
    for (auto& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension == ".ies" || extension == ".ldt";
}

}  // namespace

Command addCheck(CLI::App& program) {
    const auto path = std::make_shared<std::string>();
    auto* app = program.add_subcommand("check", "Read and check a project, a scene or a photometric file: what is in it (in m, lm and cd), what it needs, what is left out and why");
    app->add_option("file", *path, "project.toml, .glb, .gltf, .obj, .ies or .ldt")->required()->type_name("FILE");
    return {app, [path](Context& context) {
        if (isPhotometric(*path)) {
            const auto photometry = loadPhotometry(*path);
            if (!photometry) return complain(photometry.error());
            const auto told = writeOutput("-", context.common.json ? jsonText(photometryJson(*photometry)) : photometryText(*photometry));
            return told ? Exit::Ok : complain(told.error());
        }
        const auto loaded = load(*path, context.common.quiet);
        if (!loaded) return complain(loaded.error());
        if (context.progress.cancelled()) return Exit::Interrupted;
        const auto told = writeOutput("-", context.common.json ? jsonText(projectJson(**loaded)) : projectText(**loaded));
        return told ? Exit::Ok : complain(told.error());
    }};
}

}  // namespace luxdeck::cli
