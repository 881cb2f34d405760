#pragma once

#include "gui/view3d/layer.h"
#include "gui/view3d/sphere_glyphs.h"

#include <vtkNew.h>

#include <memory>

class vtkActor;

namespace luxdeck::gui {

/// Spheres of radiance, irradiance or a higher moment at the vertices of the view's volume: each shows, in every direction,
/// what a small surface there that faces that way would get. Vertices inside solids are small grey crosses.
class GlyphLayer : public Layer {
public:
    explicit GlyphLayer(vtkRenderer& renderer);
    ~GlyphLayer() override;

    Range lightRange(const Session& session, const ViewSettings& view) override;
    bool update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) override;

private:
    void take(const Session& session, const ViewSettings& view);
    void markUnusable(const IrradianceVolume& volume);

    vtkRenderer& renderer_;
    SphereGlyphs glyphs_;
    vtkNew<vtkActor> crosses_;
    std::shared_ptr<const LightSpheres> wanted_, coloured_;     // what is known; what is drawn
    std::shared_ptr<const IrradianceVolume> placed_;
    ResolvedScale scale_;
    double radiusM_ = 0;
    bool visible_ = false;
};

}  // namespace luxdeck::gui
