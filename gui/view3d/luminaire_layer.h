#pragma once

#include "gui/view3d/layer.h"
#include "gui/view3d/shared_scene.h"
#include "gui/view3d/view_colours.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

namespace luxdeck::gui {

/// Luminaires: luminous openings as bodies in the colour of their light (grey when off), the short name of their type
/// beside them, photometric solids on demand and for the one that is selected, with the line it is aimed along.
class LuminaireLayer : public Layer {
public:
    LuminaireLayer(vtkRenderer& renderer, const SharedScene& shared);

    bool update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) override;
    void setMoving(bool moving) override;
    void annotate(std::vector<Annotation>& to) const override;
    void setColours(const ViewColours& colours);
    /// Shows the selected luminaire elsewhere than it is, until the next project.
    void placeSelected(const vtkMatrix4x4& where);

private:
    struct Drawn {
        vtkNew<vtkPolyDataMapper> mapper;
        vtkNew<vtkActor> actor;
    };
    void add(Drawn& drawn);
    void rebuild();
    void rebuildSelected();
    void restyle();
    void clip();
    [[nodiscard]] const Scene* scene() const { return shared_.project ? &shared_.project->project.scene : nullptr; }
    [[nodiscard]] double metresPerCandela() const;

    vtkRenderer& renderer_;
    const SharedScene& shared_;
    std::shared_ptr<const LitProject> of_;
    Drawn bodies_, outlines_, solids_;
    Drawn selectedOutline_, selectedSolid_, selectedBody_, aim_;
    std::int64_t selected_ = -1;
    bool shown_ = true, allSolids_ = false, moving_ = false;
    CutPlane cut_;
    vtkNew<vtkPlane> section_;
    ViewColours colours_;
};

}  // namespace luxdeck::gui
