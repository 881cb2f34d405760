#include "cli/command.h"
#include "cli/completions.h"
#include "cli/furniture_commands.h"
#include "cli/interrupt.h"
#include "cli/man_page.h"
#include "cli/progress_bar.h"
#include "cli/streams.h"
#include "engine/core/parallel.h"
#include "engine/core/version.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <sstream>
#include <utility>
#include <vector>

namespace luxdeck::cli {

namespace {

constexpr const char* kFooter =
    "Exit status: 0 ok; 1 computed, a requirement is not met; 2 usage; 3 input unreadable or invalid;\n"
    "4 target error not reached in the time; 5 memory or disk; 6 internal error; 130 interrupted.";

/// Options that stand behind any command.
void addCommon(CLI::App& app, Common& common) {
    app.add_flag("--json", common.json, "Machine-readable output on stdout");
    app.add_flag("-q,--quiet", common.quiet, "No progress and no notes on stderr");
    app.add_option("--threads", common.threads, "Threads to use; 0: all cores. Results do not depend on it")
        ->check(CLI::Range(0, 1024))->capture_default_str();
    app.add_option("--seed", common.seed, "Of all random numbers: same seed, same result")
        ->check(CLI::NonNegativeNumber)->capture_default_str();
}

std::vector<Command> addCommands(CLI::App& program) {
    std::vector<Command> all{addCheck(program), addSolve(program), addSense(program), addRender(program), addTonemap(program), addExport(program), addFurniture(program), addShade(program),
                             addValidate(program), addCompare(program)};
    for (auto& command : addVolume(program)) all.push_back(std::move(command));
#ifdef LUXDECK_REPORT
    all.push_back(addReport(program));
#endif
    all.push_back(addGui(program));
    return all;
}

Exit runCommand(const Command& command, const Common& common) {
    ProgressBar bar(common.quiet);
    Progress progress([&](const ProgressState& state) { bar.show(state); });
    const InterruptGuard guard(progress);
    const ThreadLimit limit(common.threads);
    Context context{common, progress};
    const Exit exit = command.run(context);
    bar.finish();
    return exit;
}

int print(const std::string& text) {
    const auto told = writeOutput("-", text);
    return static_cast<int>(told ? Exit::Ok : complain(told.error()));
}

int run(int argc, const char* const* argv) {
    CLI::App program{"Luxdeck: lighting design in which every number carries its error and its run time.", "luxdeck"};
    program.set_version_flag("--version", fmt::format("luxdeck {}", kVersion));
    program.footer(kFooter);
    program.require_subcommand(0, 1);
    bool man = false;
    program.add_flag("--man", man, "Print the manual page (troff)");
    std::string shell;
    program.add_option("--completions", shell, "Print the completion script for a shell")
        ->check(CLI::IsMember({"bash", "zsh", "fish"}))->type_name("SHELL");
    const auto commands = addCommands(program);
    Common common;
    for (const auto& command : commands) addCommon(*command.app, common);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        std::ostringstream out, wrong;
        const int code = program.exit(e, out, wrong);
        say(wrong.str());
        return code == 0 ? print(out.str()) : static_cast<int>(Exit::Usage);
    }
    if (man) return print(manPage(program));
    if (!shell.empty()) return print(completions(program, shell == "bash" ? Shell::Bash : shell == "zsh" ? Shell::Zsh : Shell::Fish));
    for (const auto& command : commands)
        if (command.app->parsed()) return static_cast<int>(runCommand(command, common));
    say(program.help());
    return static_cast<int>(Exit::Usage);
}

}  // namespace

int runProgram(int argc, const char* const* argv) {
    occupyClosedStreams();
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        return static_cast<int>(complain({ErrorCode::OutOfResources, "out of memory", {}}));
    } catch (const std::exception& e) {
        return static_cast<int>(complain({ErrorCode::Internal, fmt::format("internal error: {}", e.what()), {}}));
    }
}

}  // namespace luxdeck::cli
