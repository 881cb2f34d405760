#pragma once

#include "engine/scene/scene.h"

#include <vtkBoundingBox.h>

namespace luxdeck::gui {

/// The scene's bounds as VTK has them [m, re-based]; a cubic metre about the origin for an empty scene.
vtkBoundingBox vtkBounds(const Scene& scene);

}  // namespace luxdeck::gui
