#include "analysis/grids/grid_points.h"
#include "cli/command.h"
#include "cli/json_text.h"
#include "cli/load.h"
#include "engine/core/file.h"
#include "engine/io/rad_view.h"
#include "engine/io/rad_writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace luxdeck::cli {

namespace {

struct Options {
    std::vector<std::string> project;
    std::string folder;
};

struct ExportFile {
    std::string name;
    std::string bytes;
};

/// A name without what a file name may not hold.
std::string fileName(const std::string& name, const char* extension, std::set<std::string>& taken) {
    std::string stem;
    for (const char c : name) stem += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.' ? c : '_';
    if (stem.empty()) stem = "unnamed";
    auto unique = stem + extension;
    for (int i = 2; !taken.insert(unique).second; ++i) unique = fmt::format("{}_{}{}", stem, i, extension);
    return unique;
}

Result<std::vector<ExportFile>> exportFiles(const Project& project, RadText text) {
    std::vector<ExportFile> files{{"materials.rad", std::move(text.materials)}, {"geometry.rad", std::move(text.geometry)}};
    if (!text.sky.empty()) files.push_back({"sky.rad", std::move(text.sky)});
    std::set<std::string> taken;
    for (const auto& grid : project.grids) {
        const auto layout = layOut(grid);
        if (!layout) return layout.error();
        files.push_back({fileName(grid.name, ".pts", taken), writePoints(layout->points, layout->normals)});
    }
    for (const auto& view : project.views) files.push_back({fileName(view.name, ".vf", taken), viewLine(view)});
    return files;
}

Exit runExport(const Options& o, Context& context) {
    namespace fs = std::filesystem;
    const auto loaded = load(o.project, context.common.quiet);
    if (!loaded) return complain(loaded.error());
    auto text = writeRad((*loaded)->project.scene);
    const auto lost = text.lost;
    const auto files = exportFiles((*loaded)->project, std::move(text));
    if (!files) return complain(files.error());
    std::error_code ec;
    fs::create_directories(o.folder, ec);
    if (!fs::is_directory(o.folder)) return complain({ErrorCode::InvalidArgument, fmt::format("cannot be made: {}", ec ? ec.message() : "a file of that name is there"), o.folder});
    nlohmann::ordered_json written = nlohmann::ordered_json::array();
    std::string told;
    for (const auto& file : *files) {
        const auto path = (fs::path(o.folder) / file.name).string();
        if (const auto ok = writeFileAtomically(path, file.bytes); !ok) return complain(ok.error());
        written.push_back(path);
        told += path + "\n";
    }
    printWarnings(lost.empty() ? lost : std::vector<std::string>{fmt::format("lost, as Radiance's files have no form for it: {}", fmt::join(lost, "; "))}, context.common.quiet);
    const nlohmann::ordered_json json{{"schema", "luxdeck-export/1"}, {"files", written}, {"lost", lost}};
    const auto shown = writeOutput("-", context.common.json ? jsonText(json) : told);
    return shown ? Exit::Ok : complain(shown.error());
}

}  // namespace

Command addExport(CLI::App& program) {
    const auto o = std::make_shared<Options>();
    auto* app = program.add_subcommand("export", "Write a project or scene as Radiance files: materials, geometry and sky (.rad), calculation points (.pts), views (.vf), in m; says what is lost");
    app->add_option("project", o->project, "project.toml or a scene file; several .rad and .mat files are one scene, in their order")->required()->type_name("PROJECT");
    app->add_option("-o,--output", o->folder, "The folder that the files go to; made when it is not there")->required()->type_name("DIR");
    return {app, [o](Context& context) { return runExport(*o, context); }};
}

}  // namespace luxdeck::cli
