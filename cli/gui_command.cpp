#include "cli/command.h"

#include "cli/streams.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <unistd.h>

namespace luxdeck::cli {

namespace {

/// The desktop program lies beside this one.
Exit startWindow(const std::string& project) {
    std::error_code ec;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", ec);
    const auto program = ec ? std::string("luxdeck-gui") : (self.parent_path() / "luxdeck-gui").string();
    if (project.empty()) execlp(program.c_str(), program.c_str(), nullptr);
    else execlp(program.c_str(), program.c_str(), project.c_str(), nullptr);
    return complain({ErrorCode::FileNotFound, fmt::format("cannot be started ({}): this build may be without it (LUXDECK_GUI)", std::strerror(errno)), program});
}

}  // namespace

Command addGui(CLI::App& program) {
    const auto project = std::make_shared<std::string>();
    auto* app = program.add_subcommand("gui", "Opens the desktop program: see the light, move furniture, compare, report");
    app->add_option("project", *project, "project.toml, a bare scene, or nothing for the start page")->type_name("[PROJECT]");
    return {app, [project](Context&) { return startWindow(*project); }};
}

}  // namespace luxdeck::cli
