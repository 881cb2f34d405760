#pragma once

#include "engine/core/result.h"
#include "engine/io/project.h"
#include "engine/transport/lit_scene.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck {

/// A project with all that light needs. On the heap: the parts refer to each other. Read only once it is made.
struct LitProject {
    Project project;
    LitScene lit;
    double seconds = 0;  // reading and building
};

/// Reads a project or a bare scene (several files: those of a Radiance scene, in their order) and makes it ready. A scene
/// without any light gets a warning.
///
/// errors  of loadProject() and LitScene::create()
Result<std::unique_ptr<LitProject>> loadLit(const std::vector<std::filesystem::path>& paths);
/// The same of a project's text that is not saved yet; the files it names are looked for beside `file`.
Result<std::unique_ptr<LitProject>> loadLit(const std::filesystem::path& file, const std::string& text);

}  // namespace luxdeck
