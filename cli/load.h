#pragma once

#include "engine/algorithms/lit_project.h"

#include <memory>
#include <string>
#include <vector>

namespace luxdeck::cli {

using Loaded = LitProject;

/// Reads a project or a bare scene and makes it ready; prints its warnings unless quiet.
Result<std::unique_ptr<Loaded>> load(const std::string& path, bool quiet);
/// The same; several files are those of a Radiance scene, read as one in their order.
Result<std::unique_ptr<Loaded>> load(const std::vector<std::string>& paths, bool quiet);

void printWarnings(const std::vector<std::string>& warnings, bool quiet);

/// The view of that name, or the first when the name is empty; a name that ends in .vf is a Radiance view file.
///
/// errors  InvalidArgument listing the views there are; those of readView()
Result<View> findView(const Project& project, const std::string& name);

}  // namespace luxdeck::cli
