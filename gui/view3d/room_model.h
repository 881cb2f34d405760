#pragma once

#include "gui/session/scene_parts.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace luxdeck::gui {

/// Triangles that are shown, hidden and moved together. Point data: "materials" and "plain", RGB as they are shown (the
/// even light that makes a room readable is in them, so views need no lamps of their own).
struct RoomPart {
    ShellSide side = ShellSide::None;
    bool glass = false;
    std::int64_t movable = -1;             ///< index of the object when it is one that can be moved, alone
    vtkSmartPointer<vtkPolyData> faces;
    vtkSmartPointer<vtkPolyData> edges;    ///< creases and borders
};

/// A scene's meshes made ready to be drawn, once for all views. Read only; safe to make on any thread.
struct RoomModel {
    std::vector<RoomPart> parts;

    static std::shared_ptr<const RoomModel> of(const Scene& scene, const SceneParts& parts);
    /// One object by itself, for showing that it is selected.
    static RoomPart object(const Scene& scene, std::uint32_t index);
};

}  // namespace luxdeck::gui
