#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace luxdeck::cli {

/// What may stand where an option (or a positional argument) takes its value.
struct CompletionValue {
    enum class Kind { None, File, Folder, Choice, Text };
    Kind kind = Kind::None;
    std::vector<std::string> choices;   // of Choice
};

struct CompletionOption {
    std::vector<std::string> names;     // "-o", "--output"; empty: positional
    std::string description;            // its first sentence
    CompletionValue value;
};

struct CompletionCommand {
    std::string name;                   // empty: the program itself
    std::string description;
    std::vector<CompletionOption> options;
    CompletionValue argument;           // of the positional arguments
    std::vector<std::string> subcommands;  // one of them stands before all else; options are those of all of them
};

/// The program itself first, then its commands in order.
std::vector<CompletionCommand> completionWords(const CLI::App& program);

}  // namespace luxdeck::cli
