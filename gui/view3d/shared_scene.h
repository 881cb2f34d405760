#pragma once

#include "gui/session/session.h"
#include "gui/view3d/room_model.h"

#include <memory>

namespace luxdeck::gui {

/// What all views have in common: the project as it is drawn. Made by ViewArea, once for all of its views and
/// beside the window, so for a moment it may be the project before session.project().
struct SharedScene {
    std::shared_ptr<const LitProject> project;   ///< null: nothing to show
    std::shared_ptr<const SceneParts> parts;     ///< of it
    std::shared_ptr<const RoomModel> room;       ///< of it
};

}  // namespace luxdeck::gui
