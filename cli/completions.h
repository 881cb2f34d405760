#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace luxdeck::cli {

enum class Shell { Bash, Zsh, Fish };

/// A completion script for a shell, from the same declarations that --help prints: commands, options, the values
/// of those that have a choice, files and folders where they are asked for. `program` has been declared in full.
std::string completions(const CLI::App& program, Shell shell);

}  // namespace luxdeck::cli
