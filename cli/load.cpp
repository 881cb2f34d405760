#include "cli/load.h"

#include "cli/streams.h"
#include "engine/core/stopwatch.h"
#include "engine/io/rad_view.h"

#include <fmt/format.h>

#include <filesystem>

namespace luxdeck::cli {

void printWarnings(const std::vector<std::string>& warnings, bool quiet) {
    if (quiet) return;
    for (const auto& warning : warnings) say(fmt::format("warning: {}\n", warning));
}

Result<std::unique_ptr<Loaded>> load(const std::string& path, bool quiet) { return load(std::vector<std::string>{path}, quiet); }

Result<std::unique_ptr<Loaded>> load(const std::vector<std::string>& paths, bool quiet) {
    const Stopwatch clock;
    auto project = loadProject(std::vector<std::filesystem::path>(paths.begin(), paths.end()));
    if (!project) return project.error();
    auto loaded = std::make_unique<Loaded>();
    loaded->project = *std::move(project);
    auto lit = LitScene::create(loaded->project.scene);
    if (!lit) return lit.error();
    loaded->lit = *std::move(lit);
    auto& scene = loaded->project.scene;
    if (scene.luminaires.empty() && !scene.sky.present() && scene.sky.suns.empty() && !loaded->lit.needs().meshLights)
        scene.warnings.emplace_back("there is no light in this scene: no luminaire, no sky and no emitting surface");
    printWarnings(scene.warnings, quiet);
    loaded->seconds = clock.seconds();
    return loaded;
}

Result<View> findView(const Project& project, const std::string& name) {
    if (name.ends_with(".vf")) return readView(name);
    std::string known;
    for (const auto& view : project.views) {
        if (name.empty() || view.name == name) return view;
        known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", view.name);
    }
    if (known.empty()) return Error{ErrorCode::InvalidArgument, "has no view: add a [[view]] (docs/project-format.md)", project.file.string()};
    return Error{ErrorCode::InvalidArgument, fmt::format("no view \"{}\", expected one of: {}", name, known), project.file.string()};
}

}  // namespace luxdeck::cli
