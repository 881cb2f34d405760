#pragma once

#include "gui/view3d/layer.h"

#include <vtkNew.h>

#include <memory>
#include <vector>

class vtkActor;

namespace luxdeck::gui {

/// Illuminance through the view's volume, on surfaces that face one way: a plane in false colour with lines of equal value,
/// and the surface where it is just so much. Walls stop interpolation; places that nothing is known of stay empty.
class SliceLayer : public Layer {
public:
    explicit SliceLayer(vtkRenderer& renderer);
    ~SliceLayer() override;

    Range lightRange(const Session& session, const ViewSettings& view) override;
    bool update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) override;
    void annotate(std::vector<Annotation>& to) const override { to.insert(to.end(), levels_.begin(), levels_.end()); }

private:
    /// What the actors were made from: as long as it is the same, they are right.
    struct MadeFrom {
        std::shared_ptr<const LightSamples> plane, room;  // null: not shown
        ResolvedScale scale;
        Units units;
        bool isolines = true;
        double isosurfaceLux = 0;

        friend bool operator==(const MadeFrom&, const MadeFrom&) = default;
    };
    void take(const Session& session, const ViewSettings& view);
    void drawPlane(const LightColours& colours);
    void drawLines(const LightColours& colours);
    void drawIsosurface(const LightColours& colours);

    vtkRenderer& renderer_;
    vtkNew<vtkActor> plane_, lines_, isosurface_;
    std::shared_ptr<const LightSamples> wantedPlane_, wantedRoom_;
    Range planeRange_;
    std::shared_ptr<const LightSamples> rangeOf_;
    MadeFrom from_;
    std::vector<Annotation> levels_;
};

}  // namespace luxdeck::gui
