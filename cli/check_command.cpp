#include "cli/check_aside.h"
#include "cli/check_photometry.h"
#include "cli/command.h"
#include "cli/json_text.h"
#include "cli/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::cli {

namespace {

using Json = nlohmann::ordered_json;

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

Exit checkScene(const std::vector<std::string>& paths, const Context& context) {
    const auto loaded = load(paths, context.common.quiet);
    if (!loaded) return complain(loaded.error());
    if (context.progress.cancelled()) return Exit::Interrupted;
    const auto told = writeOutput("-", context.common.json ? jsonText(projectJson(**loaded)) : projectText(**loaded));
    return told ? Exit::Ok : complain(told.error());
}

struct Options {
    std::vector<std::string> files;
    std::string drawing;
};

Exit runCheck(const Options& o, const Context& context) {
    const auto photometric = std::count_if(o.files.begin(), o.files.end(), isPhotometric);
    if (static_cast<std::size_t>(photometric) == o.files.size()) return checkPhotometry(o.files, o.drawing, context);
    if (photometric > 0)
        return complain({ErrorCode::InvalidArgument, fmt::format("{} files, expected one project or scene, Radiance files (.rad, .mat) of one scene, or photometric files alone", o.files.size()), o.files[0]});
    if (!o.drawing.empty())
        return complain({ErrorCode::InvalidArgument, "is no photometric file (.ies, .ldt): there is nothing to draw with -o", o.files[0]});
    const auto aside = static_cast<std::size_t>(std::count_if(o.files.begin(), o.files.end(), isAside));
    if (aside == o.files.size()) return checkAside(o.files, context);
    if (aside > 0) {
        const auto first = std::find_if(o.files.begin(), o.files.end(), isAside);
        return complain({ErrorCode::InvalidArgument, "is no part of a scene: expected it checked alone", *first});
    }
    return checkScene(o.files, context);
}

}  // namespace

Command addCheck(CLI::App& program) {
    const auto o = std::make_shared<Options>();
    auto* app = program.add_subcommand("check", "Read and check a project, a scene or photometric files: what is in it (in m, lm and cd), where it belongs, what it needs, what is left out, repaired or refused, and why");
    app->add_option("file", o->files, "project.toml, .glb, .gltf, .obj, the .rad and .mat of one scene in their order, one or more .ies and .ldt, or weather (.epw, .wea), pictures (.hdr, .exr, .png) and .mtl")->required()->type_name("FILE");
#ifdef LUXDECK_REPORT
    app->add_option("-o,--output", o->drawing, "Draw the photometric file: polar curve and intensity by C plane in cd, .png, .pdf or .svg")->type_name("F.png");
#endif
    return {app, [o](Context& context) { return runCheck(*o, context); }};
}

}  // namespace luxdeck::cli
