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

#include <optional>
#include <vector>

namespace luxdeck::gui {

/// The geometry: walls, furniture, panes. Sides of the room that stand in the way are left out, what a section cuts away
/// too; the selected object is marked.
class RoomLayer : public Layer {
public:
    RoomLayer(vtkRenderer& renderer, const SharedScene& shared);
    ~RoomLayer() override;

    bool update(const Session& session, const ViewSettings& view, const ResolvedScale& scale) override;
    /// Which sides are left out (SceneParts::sidesInTheWay). Returns whether the picture changes.
    bool hideSides(std::uint32_t sides);
    /// Without its lines and panes: they take half of a frame.
    void setMoving(bool moving) override;
    bool setColours(const ViewColours& colours);
    /// Shows an object elsewhere than it is, until the next project.
    void place(std::uint32_t object, const vtkMatrix4x4& where);
    /// Leaves one movable object to another layer; -1: none.
    void leaveOut(std::int64_t object);

private:
    struct Shown {
        const RoomPart* part = nullptr;
        vtkNew<vtkPolyDataMapper> faceMapper, edgeMapper;
        vtkNew<vtkActor> faces, edges;
    };
    void rebuild();
    void restyle();
    void clip();
    void mark(const Selection& selection);
    static void prepare(Shown& shown);

    vtkRenderer& renderer_;
    const SharedScene& shared_;
    std::shared_ptr<const RoomModel> model_;  // that the actors are of
    std::vector<std::unique_ptr<Shown>> shown_;
    std::optional<RoomPart> markedPart_;
    std::unique_ptr<Shown> marked_;
    vtkNew<vtkPlane> section_;
    Selection selection_;
    ViewSettings view_;
    ViewColours colours_;
    std::uint32_t hiddenSides_ = 0;
    std::int64_t leftOut_ = -1;
    bool moving_ = false;
};

}  // namespace luxdeck::gui
