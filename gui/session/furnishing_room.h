#pragma once

#include "analysis/furniture/movable_object.h"
#include "engine/algorithms/lit_project.h"
#include "engine/core/progress.h"
#include "gui/session/volumes.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck::gui {

/// The room without an object, and its volume.
struct EmptyRoom {
    std::shared_ptr<const LitProject> project;
    std::shared_ptr<const IrradianceVolume> volume;
    bool built = false;  ///< else it was known
};

/// Takes the volume of the room from those that are known, or builds it.
///
/// request  empty: as the project's [[volume]] says
/// errors   InvalidArgument: no such object; of buildVolume()
Result<EmptyRoom> emptyRoom(const LitProject& project, const std::string& object, const std::vector<VolumeState>& known,
                            const std::optional<VolumeRequest>& request, const Progress& progress);

/// The mean illuminance that is required where an object's working surface lies, and by which calculation surface: of those
/// that lie on it (to 0.3 m above) the one most of whose area does.
struct RequiredLight {
    std::string grid;
    double meanLux = 0;
};
std::optional<RequiredLight> requiredOn(const Project& project, const MovableObject& object);

}  // namespace luxdeck::gui
