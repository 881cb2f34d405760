#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace luxdeck::cli {

/// The manual page in troff, from the same declarations that --help prints.
std::string manPage(const CLI::App& program);

}  // namespace luxdeck::cli
