#include "gui/view3d/scene_bounds.h"

namespace luxdeck::gui {

vtkBoundingBox vtkBounds(const Scene& scene) {
    const auto box = scene.bounds();
    if (box.isEmpty()) return vtkBoundingBox(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
    return vtkBoundingBox(box.min.x, box.max.x, box.min.y, box.max.y, box.min.z, box.max.z);
}

}  // namespace luxdeck::gui
