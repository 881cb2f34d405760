#pragma once

#include "engine/io/cal_module.h"

#include <memory>
#include <span>
#include <string_view>

namespace luxdeck::cal {

/// What every function file may use, besides nativeFunctions(): the definitions of Radiance's rayinit.cal.
const std::shared_ptr<const Module>& standardLibrary();

/// Function files that Radiance brings along, written anew from what they mean
/// (docs/decisions/*-radiance-function-files.md): their text; empty for others.
std::string_view builtinFile(std::string_view name);

/// Names of the function files that are built in, for messages and tests.
std::span<const std::string_view> builtinFileNames();

}  // namespace luxdeck::cal
