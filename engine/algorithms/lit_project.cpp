#include "engine/algorithms/lit_project.h"

#include "engine/core/stopwatch.h"

#include <utility>

namespace luxdeck {

namespace {

Result<std::unique_ptr<LitProject>> makeReady(Result<Project> project, const Stopwatch& clock) {
    if (!project) return project.error();
    auto loaded = std::make_unique<LitProject>();
    loaded->project = *std::move(project);
    auto lit = LitScene::create(loaded->project.scene);
    if (!lit) return lit.error();
    loaded->lit = *std::move(lit);
    auto& scene = loaded->project.scene;
    if (scene.luminaires.empty() && !scene.sky.present() && scene.sky.suns.empty() && !loaded->lit.needs().meshLights)
        scene.warnings.emplace_back("there is no light in this scene: no luminaire, no sky and no emitting surface");
    loaded->seconds = clock.seconds();
    return loaded;
}

}  // namespace

Result<std::unique_ptr<LitProject>> loadLit(const std::vector<std::filesystem::path>& paths) {
    const Stopwatch clock;
    return makeReady(loadProject(paths), clock);
}

Result<std::unique_ptr<LitProject>> loadLit(const std::filesystem::path& file, const std::string& text) {
    const Stopwatch clock;
    return makeReady(loadProjectText(file, text), clock);
}

}  // namespace luxdeck
