#pragma once

#include "cli/command.h"
#include "cli/load.h"
#include "engine/volume/field.h"

#include <map>
#include <string>

namespace luxdeck::cli {

Command addVolumeBuild(CLI::App& volume);
Command addVolumeQuery(CLI::App& volume);
Command addVolumeInfo(CLI::App& volume);
Command addVolumeDiff(CLI::App& volume);
Command addVolumeExport(CLI::App& volume);

/// Options of commands that ask a volume for light.
struct FieldOptions {
    FieldSettings settings;
    bool thesis = false;  // its own quadrature

    [[nodiscard]] FieldSettings field() const;
};

void addFieldOptions(CLI::App& app, FieldOptions& options);

/// "total", "direct", "indirect".
const std::map<std::string, LightPart>& lightParts();

}  // namespace luxdeck::cli
