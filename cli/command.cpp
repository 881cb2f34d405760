#include "cli/command.h"

#include "cli/streams.h"
#include "engine/algorithms/registry.h"
#include "engine/core/file.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace luxdeck::cli {

Exit exitOf(ErrorCode code) {
    switch (code) {
        case ErrorCode::InvalidArgument:
        case ErrorCode::FileNotFound:
        case ErrorCode::Parse:
        case ErrorCode::Unsupported: return Exit::BadInput;
        case ErrorCode::OutOfResources: return Exit::Resources;
        case ErrorCode::Cancelled: return Exit::Interrupted;
        case ErrorCode::Internal: return Exit::Internal;
    }
    return Exit::Internal;
}

Exit complain(const Error& error) {
    say(fmt::format("luxdeck: {}\n", error.text()));
    return exitOf(error.code);
}

AlgorithmSettings Effort::settings() const {
    AlgorithmSettings s;
    s.ambientLux = ambientLux;
    s.effort = preparation;
    return s;
}

namespace {

/// The number at the start of `text`, and what follows it.
bool splitNumber(const std::string& text, double& value, std::string& unit) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    unit.assign(end, text.data() + text.size());
    return error == std::errc{};
}

}  // namespace

std::string parsePercent(const std::string& text, double& value) {
    std::string unit;
    if (!splitNumber(text, value, unit) || (!unit.empty() && unit != "%"))
        return fmt::format("\"{}\" is not an error, expected a percentage such as 2% or a fraction such as 0.02", text);
    if (unit == "%") value /= 100;
    if (!(value > 0 && value < 1)) return fmt::format("{} is not an error, expected more than 0 and less than 100 %", text);
    return {};
}

std::string parseSeconds(const std::string& text, double& value) {
    std::string unit;
    const bool number = splitNumber(text, value, unit);
    const double factor = unit.empty() || unit == "s" ? 1 : unit == "min" ? 60 : unit == "h" ? 3600 : 0;
    if (!number || factor == 0 || !(value > 0 && value < 1e9))
        return fmt::format("\"{}\" is not a time, expected seconds (60, 60s) or minutes (1.5min)", text);
    value *= factor;
    return {};
}

void addEffort(CLI::App& app, Effort& effort) {
    std::vector<std::string> names;
    std::string summaries;
    for (const auto& a : algorithms()) {
        names.push_back(a.name);
        summaries += fmt::format("{}{}: {}", summaries.empty() ? "" : "; ", a.name, a.summary);
    }
    app.add_option("--algorithm", effort.algorithm, "How light is computed. " + summaries)
        ->check(CLI::IsMember(names))->capture_default_str();
    app.add_option("--ambient", effort.ambientLux, "Constant ambient illuminance of --algorithm ambient, in lx")
        ->check(CLI::Range(0.0, 1e6))->capture_default_str();
    app.add_option("--effort", effort.preparation, "Of algorithms that prepare something first (a cache, a mesh, photons): its time is about proportional, its error falls")
        ->check(CLI::Range(1e-3, 1e3))->capture_default_str();
    app.add_option_function<std::string>("--target-error", [&effort](const std::string& text) {
        double value = 0;
        if (const auto wrong = parsePercent(text, value); !wrong.empty()) throw CLI::ValidationError("--target-error", wrong);
        effort.targetError = value;
    }, "Stop when every number is known to this (95 % interval over value): 2%, 0.02")->type_name("P");
    app.add_option_function<std::string>("--time", [&effort](const std::string& text) {
        double value = 0;
        if (const auto wrong = parseSeconds(text, value); !wrong.empty()) throw CLI::ValidationError("--time", wrong);
        effort.timeSeconds = value;
    }, "Stop after this time in seconds: 60, 60s, 1.5min")->type_name("S");
    app.add_option_function<std::uint32_t>("--samples", [&effort](std::uint32_t n) { effort.samples = n; },
        "Exactly this many paths for each point (or pixel), instead of a target")->check(CLI::Range(1, 1 << 30))->type_name("N");
}

Result<void> writeOutput(const std::string& path, const std::string& bytes) {
    if (path != "-") return writeFileAtomically(path, bytes);
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
        return Error{ErrorCode::OutOfResources, fmt::format("cannot be written: {}", std::strerror(errno)), "stdout"};
    return {};
}

Result<void> checkOutput(const std::string& path) {
    namespace fs = std::filesystem;
    if (path == "-") return {};
    std::error_code ec;
    if (fs::is_directory(path, ec)) return Error{ErrorCode::InvalidArgument, "is a folder, expected a file to write", path};
    auto folder = fs::path(path).parent_path();
    if (folder.empty()) folder = ".";
    if (!fs::is_directory(folder, ec))
        return Error{ErrorCode::InvalidArgument, fmt::format("cannot be written: there is no folder {}", folder.string()), path};
    if (fs::exists(path, ec) && !fs::is_regular_file(path, ec)) return {};  // a device needs no place in its folder
    if (::access(folder.c_str(), W_OK) != 0)
        return Error{ErrorCode::InvalidArgument, fmt::format("cannot be written: {}", std::strerror(errno)), path};
    return {};
}

CLI::Validator namedAs(const std::string& extension) {
    return CLI::Validator([extension](std::string& text) -> std::string {
        namespace fs = std::filesystem;
        std::error_code ec;
        const fs::path path(text);
        if (CLI::detail::to_lower(path.extension().string()) == extension) return {};
        if (fs::exists(path, ec) && !fs::is_regular_file(path, ec) && !fs::is_directory(path, ec)) return {};
        return fmt::format("\"{}\", expected a name that ends in {}", text, extension);
    }, "");
}

}  // namespace luxdeck::cli
