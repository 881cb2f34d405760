#include "gui/view3d/room_layer.h"

#include "gui/view3d/section_plane.h"

#include <vtkPointData.h>
#include <vtkProperty.h>

namespace luxdeck::gui {

namespace {

constexpr double kGlassOpacity = 0.22;
constexpr double kEdgeOpacity = 0.28;
constexpr double kMarkOpacity = 0.32;
constexpr double kToTheFront = -66000;  // in VTK's units of depth: all of it

}  // namespace

RoomLayer::RoomLayer(vtkRenderer& renderer, const SharedScene& shared) : renderer_(renderer), shared_(shared) {}

RoomLayer::~RoomLayer() = default;

void RoomLayer::prepare(Shown& shown) {
    shown.faceMapper->SetInputData(shown.part->faces);
    shown.faceMapper->SetScalarModeToUsePointFieldData();
    shown.faceMapper->SetColorModeToDirectScalars();
    // Faces a little back, so that the lines on them are whole.
    shown.faceMapper->SetResolveCoincidentTopologyToPolygonOffset();
    shown.faceMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 1);
    shown.faces->SetMapper(shown.faceMapper);
    shown.faces->GetProperty()->LightingOff();
    shown.edgeMapper->SetInputData(shown.part->edges);
    shown.edges->SetMapper(shown.edgeMapper);
    shown.edges->GetProperty()->LightingOff();
    shown.edges->PickableOff();
}

void RoomLayer::rebuild() {
    for (const auto& shown : shown_) {
        renderer_.RemoveActor(shown->faces);
        renderer_.RemoveActor(shown->edges);
    }
    shown_.clear();
    model_ = shared_.room;
    if (!model_) return;
    for (const auto& part : model_->parts) {
        auto shown = std::make_unique<Shown>();
        shown->part = &part;
        prepare(*shown);
        renderer_.AddActor(shown->faces);
        renderer_.AddActor(shown->edges);
        shown_.push_back(std::move(shown));
    }
}

void RoomLayer::restyle() {
    const bool wire = view_.surfaces == SurfaceLook::Wireframe, none = view_.surfaces == SurfaceLook::Hidden;
    for (const auto& shown : shown_) {
        const bool leftOut = leftOut_ >= 0 && shown->part->movable == leftOut_;
        const bool hidden = none || leftOut || (hiddenSides_ >> static_cast<unsigned>(shown->part->side) & 1U) != 0;
        shown->faces->SetVisibility(!hidden && !wire && !(moving_ && shown->part->glass));
        shown->edges->SetVisibility(!hidden && (wire || !moving_));
        shown->faceMapper->SelectColorArray(view_.surfaces == SurfaceLook::Plain ? "plain" : "materials");
        shown->faces->GetProperty()->SetOpacity(shown->part->glass ? kGlassOpacity : 1);
        const auto edge = rgbOf(wire ? colours_.ink : colours_.edge);
        shown->edges->GetProperty()->SetColor(edge[0], edge[1], edge[2]);
        shown->edges->GetProperty()->SetOpacity(wire ? 0.35 : kEdgeOpacity);
    }
    if (!marked_) return;
    const auto accent = rgbOf(colours_.accent);
    for (auto* actor : {marked_->faces.Get(), marked_->edges.Get()}) actor->GetProperty()->SetColor(accent[0], accent[1], accent[2]);
    marked_->faces->SetVisibility(!none && !wire && selection_ != Selection{Thing::Object, static_cast<std::size_t>(leftOut_)});
}

void RoomLayer::clip() {
    const auto apply = [&](Shown& shown) {
        for (vtkMapper* mapper : {static_cast<vtkMapper*>(shown.faceMapper), static_cast<vtkMapper*>(shown.edgeMapper)}) {
            mapper->RemoveAllClippingPlanes();
            if (view_.section.on) mapper->AddClippingPlane(section_);
        }
    };
    if (view_.section.on && shared_.parts) placeSection(*section_, view_.section, shared_.parts->sceneBounds());
    for (const auto& shown : shown_) apply(*shown);
    if (marked_) apply(*marked_);
}

void RoomLayer::mark(const Selection& selection) {
    selection_ = selection;
    if (marked_) {
        renderer_.RemoveActor(marked_->faces);
        renderer_.RemoveActor(marked_->edges);
    }
    marked_.reset();
    if (!shared_.project || selection.thing != Thing::Object || selection.index >= shared_.project->project.scene.objects.size()) return;
    markedPart_ = RoomModel::object(shared_.project->project.scene, static_cast<std::uint32_t>(selection.index));
    marked_ = std::make_unique<Shown>();
    marked_->part = &*markedPart_;
    prepare(*marked_);
    marked_->faceMapper->ScalarVisibilityOff();
    marked_->faceMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, 0);
    marked_->faces->GetProperty()->SetOpacity(kMarkOpacity);
    marked_->edges->GetProperty()->SetLineWidth(2.5F);
    // Before everything: it is to be found behind calculation surfaces too.
    marked_->edgeMapper->SetResolveCoincidentTopologyToPolygonOffset();
    marked_->edgeMapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, kToTheFront);
    renderer_.AddActor(marked_->faces);
    renderer_.AddActor(marked_->edges);
}

bool RoomLayer::update(const Session& session, const ViewSettings& view, const ResolvedScale& /*scale*/) {
    const bool fresh = model_ != shared_.room;
    const bool styled = fresh || view.surfaces != view_.surfaces || view.section != view_.section;
    const bool marks = fresh || session.selection() != selection_;
    if (fresh) rebuild();
    if (marks) mark(session.selection());
    view_ = view;
    if (!styled && !marks) return false;
    restyle();
    clip();
    return true;
}

bool RoomLayer::hideSides(std::uint32_t sides) {
    if (sides == hiddenSides_) return false;
    hiddenSides_ = sides;
    restyle();
    return true;
}

void RoomLayer::setMoving(bool moving) {
    moving_ = moving;
    restyle();
}

bool RoomLayer::setColours(const ViewColours& colours) {
    colours_ = colours;
    restyle();
    return true;
}

void RoomLayer::leaveOut(std::int64_t object) {
    if (object == leftOut_) return;
    leftOut_ = object;
    restyle();
}

void RoomLayer::place(std::uint32_t object, const vtkMatrix4x4& where) {
    const auto put = [&](Shown& shown) {
        vtkNew<vtkMatrix4x4> matrix;
        matrix->DeepCopy(&where);
        shown.faces->SetUserMatrix(matrix);
        shown.edges->SetUserMatrix(matrix);
    };
    for (const auto& shown : shown_)
        if (shown->part->movable == std::int64_t{object}) put(*shown);
    if (marked_ && selection_ == Selection{Thing::Object, object}) put(*marked_);
}

}  // namespace luxdeck::gui
