#pragma once

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/io/project.h"
#include "engine/transport/radiance_estimator.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck::cli {

/// What the program's exit status says; the manual lists it.
enum class Exit {
    Ok = 0,
    NotMet = 1,        // computed, a requirement is not met
    Usage = 2,
    BadInput = 3,      // unreadable or invalid: file:line, seen, expected
    NotReached = 4,    // the target error was not reached in the time given
    Resources = 5,     // memory, disk
    Internal = 6,
    Interrupted = 130
};

Exit exitOf(ErrorCode code);
/// "luxdeck: file:line: message" on stderr, and the exit status that belongs to it.
Exit complain(const Error& error);

/// Options that every command has.
struct Common {
    bool json = false;
    bool quiet = false;
    int threads = 0;         // 0: all cores
    std::uint64_t seed = 1;
};

/// Options of commands that compute light.
struct Effort {
    std::string algorithm = "path";
    double ambientLux = 0;
    double preparation = 1;                // effort of algorithms that prepare something
    std::optional<double> targetError;     // relative
    std::optional<double> timeSeconds;
    std::optional<std::uint32_t> samples;

    [[nodiscard]] AlgorithmSettings settings() const;
};

void addEffort(CLI::App& app, Effort& effort);

/// What a command works with while it runs.
struct Context {
    Common common;
    Progress& progress;      // draws the bar and hears Ctrl-C
};

/// One command: its options declared on a subcommand, its work behind run().
struct Command {
    CLI::App* app = nullptr;
    std::function<Exit(Context&)> run;
};

Command addCheck(CLI::App& program);
Command addSolve(CLI::App& program);
Command addSense(CLI::App& program);
Command addRender(CLI::App& program);
Command addExport(CLI::App& program);
Command addTonemap(CLI::App& program);
Command addValidate(CLI::App& program);
Command addCompare(CLI::App& program);
Command addGui(CLI::App& program);
/// build, query, info, diff and export, each a command of its own behind `volume`.
std::vector<Command> addVolume(CLI::App& program);
#ifdef LUXDECK_REPORT
Command addReport(CLI::App& program);
#endif

/// "2%" or "0.02" -> 0.02; "90", "90s", "1.5min" -> seconds. Errors say what was expected.
std::string parsePercent(const std::string& text, double& value);
std::string parseSeconds(const std::string& text, double& value);

/// Writes to a file (atomically) or, for "-", to stdout.
Result<void> writeOutput(const std::string& path, const std::string& bytes);

/// Whether a file can be made there, asked before long work instead of after it.
Result<void> checkOutput(const std::string& path);

/// Of an option that names an output: what is written is of one kind, whatever the name says. Devices pass.
CLI::Validator namedAs(const std::string& extension);

/// The whole program: parses, runs, returns the exit status.
int runProgram(int argc, const char* const* argv);

}  // namespace luxdeck::cli
