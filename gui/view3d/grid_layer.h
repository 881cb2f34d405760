#pragma once

#include "gui/view3d/grid_shapes.h"
#include "gui/view3d/layer.h"
#include "gui/view3d/shared_scene.h"
#include "gui/view3d/view_colours.h"

#include <memory>
#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

namespace luxdeck::gui {

/// Calculation surfaces: in the colours of their illuminance with lines of equal value, numbers and verdicts; before the
/// first solve their outlines and points. An old result has little colour and says that it is old.
class GridLayer : public Layer {
public:
    GridLayer(vtkRenderer& renderer, const SharedScene& shared);
    ~GridLayer() override;

    Range lightRange(const Session& session, const ViewSettings& view) override;
    bool update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) override;
    void annotate(std::vector<Annotation>& to) const override { to.insert(to.end(), texts_.begin(), texts_.end()); }
    void setColours(const ViewColours& colours);

private:
    struct Surface;
    /// What the actors were made from: as long as it is the same, they are right.
    struct MadeFrom {
        std::shared_ptr<const LitProject> project;
        std::shared_ptr<const SolveResult> result;
        bool current = true;
        ResolvedScale scale;
        Units units;
        ViewSettings view;
        std::optional<std::size_t> selected;

        friend bool operator==(const MadeFrom&, const MadeFrom&) = default;
    };
    void clear();
    void rebuild();
    void addResults(const LightColours& colours);
    void addSurface(const GridResult& grid, std::size_t index, const LightColours& colours);
    void addOutlines();
    void addPoints(const std::vector<PointSet>& sets, const LightColours& colours);
    void addValues(const GridResult& grid, std::size_t index, const LightColours& colours);
    void addTitle(const GridResult& grid, std::size_t index);
    Surface& newSurface();
    void restyle();
    [[nodiscard]] bool chosen(std::size_t index) const { return from_.selected == index; }
    [[nodiscard]] Vec3d rebased(const Vec3d& user) const { return user - shared_.project->project.scene.origin; }

    vtkRenderer& renderer_;
    const SharedScene& shared_;
    MadeFrom from_;
    std::vector<std::unique_ptr<Surface>> surfaces_;
    std::vector<Annotation> texts_;
    vtkNew<vtkPlane> section_;
    ViewColours colours_;
};

}  // namespace luxdeck::gui
