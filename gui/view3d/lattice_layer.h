#pragma once

#include "gui/view3d/layer.h"

#include <vtkNew.h>

#include <memory>

class vtkActor;

namespace luxdeck::gui {

/// The lines between a volume's vertices: cells of the first level, and those that a division of them made.
class LatticeLayer : public Layer {
public:
    explicit LatticeLayer(vtkRenderer& renderer);
    ~LatticeLayer() override;

    bool update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) override;

private:
    vtkRenderer& renderer_;
    vtkNew<vtkActor> first_, second_;
    std::shared_ptr<const IrradianceVolume> drawn_;
};

}  // namespace luxdeck::gui
