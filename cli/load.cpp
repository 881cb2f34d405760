#include "cli/load.h"

#include "cli/streams.h"
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
    auto loaded = loadLit(std::vector<std::filesystem::path>(paths.begin(), paths.end()));
    if (loaded) printWarnings((*loaded)->project.scene.warnings, quiet);
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
