#pragma once

#include "gui/view3d/layer.h"

#include <memory>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

namespace luxdeck {
struct MovableObject;
}

namespace luxdeck::gui {

/// The piece of furniture that is in hand (Session::furnishing), in the colours of the illuminance on it.
class FurnitureLayer : public Layer {
public:
    explicit FurnitureLayer(vtkRenderer& renderer);
    ~FurnitureLayer() override;

    Range lightRange(const Session& session, const ViewSettings& view) override;
    bool update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) override;
    /// It shows the object, which the room then need not.
    [[nodiscard]] bool shown() const { return actor_->GetVisibility() != 0; }

private:
    void take(const MovableObject& object);

    vtkRenderer& renderer_;
    vtkNew<vtkPolyData> mesh_;
    vtkNew<vtkPolyDataMapper> mapper_;
    vtkNew<vtkActor> actor_;
    const FurnitureLighting* of_ = nullptr;   // whose mesh it is; compared, never followed
    std::vector<float> lux_;                  // that the colours are of
    Placement place_;
    ResolvedScale scale_;
};

}  // namespace luxdeck::gui
