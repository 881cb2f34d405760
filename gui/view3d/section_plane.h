#pragma once

#include "gui/session/scene_pick.h"

#include <vtkPlane.h>

namespace luxdeck::gui {

/// Makes a plane for mappers' clipping of a section: what is on the side of its normal goes.
inline void placeSection(vtkPlane& plane, const CutPlane& section, const Box3& bounds) {
    const auto point = sectionPoint(section, bounds);
    plane.SetOrigin(point.x, point.y, point.z);
    plane.SetNormal(-section.normal.x, -section.normal.y, -section.normal.z);
}

}  // namespace luxdeck::gui
