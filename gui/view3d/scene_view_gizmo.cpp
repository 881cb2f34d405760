#include "gui/view3d/furniture_layer.h"
#include "gui/view3d/luminaire_layer.h"
#include "gui/view3d/room_layer.h"
#include "gui/view3d/scene_view.h"
#include "gui/view3d/view_overlay.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>

#include <vtkMatrix4x4.h>

/// Moving what is selected by its handles.
namespace luxdeck::gui {

namespace {

/// Turned about the vertical through a point, then shifted.
vtkSmartPointer<vtkMatrix4x4> matrixOf(const Vec3d& about, const GizmoMotion& motion) {
    const double c = std::cos(motion.turnDeg * kDegree), s = std::sin(motion.turnDeg * kDegree);
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    matrix->SetElement(0, 0, c);
    matrix->SetElement(0, 1, -s);
    matrix->SetElement(1, 0, s);
    matrix->SetElement(1, 1, c);
    matrix->SetElement(0, 3, about.x - c * about.x + s * about.y + motion.moveM.x);
    matrix->SetElement(1, 3, about.y - s * about.x - c * about.y + motion.moveM.y);
    matrix->SetElement(2, 3, motion.moveM.z);
    return matrix;
}

Snapping snappingOf(Qt::KeyboardModifiers keys) {
    if ((keys & Qt::ControlModifier) != 0) return Snapping::off();
    return (keys & Qt::ShiftModifier) != 0 ? Snapping::fine() : Snapping{};
}

}  // namespace

/// Where the project has the point that an object turns about: as Pose.
Vec3d SceneView::pivotOf(std::size_t object) const {
    const auto& box = shared_.parts->bounds(static_cast<std::uint32_t>(object));
    return {0.5 * (double{box.min.x} + double{box.max.x}), 0.5 * (double{box.min.y} + double{box.max.y}), double{box.min.z}};
}

bool SceneView::inHand(std::size_t object) const {
    return shared_.project == session_.project() && session_.furnishing.object() == shared_.project->project.scene.objects[object].name;
}

/// Furniture that may be moved, and luminaires; of projects that can be changed.
std::optional<Gizmo::Target> SceneView::gizmoTarget() const {
    if (!shared_.project || !session_.editable()) return {};
    const auto& scene = shared_.project->project.scene;
    const auto& [thing, index] = session_.selection();
    if (thing == Thing::Luminaire && index < scene.luminaires.size() && settings().luminaires) return Gizmo::Target{Vec3d(scene.luminaires[index].position), true, false};
    if (thing != Thing::Object || index >= scene.objects.size() || !scene.objects[index].movable) return {};
    if (shared_.parts->bounds(static_cast<std::uint32_t>(index)).isEmpty()) return {};
    return Gizmo::Target{pivotOf(index) + (inHand(index) ? session_.furnishing.pose().moveM : Vec3d(0, 0, 0)), false, true};
}

void SceneView::placeInHand() {
    const auto& name = session_.furnishing.object();
    std::int64_t lit = -1;
    if (shared_.project && !name.empty()) {
        const auto& objects = shared_.project->project.scene.objects;
        const auto at = std::find_if(objects.begin(), objects.end(), [&](const SceneObject& object) { return object.name == name; });
        const auto index = static_cast<std::size_t>(at - objects.begin());
        if (at != objects.end() && at->movable && inHand(index) && !gizmo_.dragging()) {
            const auto& pose = session_.furnishing.pose();
            room_->place(static_cast<std::uint32_t>(index), *matrixOf(pivotOf(index), {pose.moveM, pose.turnDeg}));
            requestRender();
        }
        if (at != objects.end() && furniture_->shown()) lit = static_cast<std::int64_t>(index);
    }
    room_->leaveOut(lit);
}

void SceneView::aimGizmo() {
    gizmo_.setTarget(gizmoTarget());
    if (!gizmo_.target()) return;
    const double depth = std::max(depthOf(pose_, gizmo_.target()->centre), 0.1);
    gizmo_.setScale(2 * metresPerUnit(pose_, depth) / std::max(height(), 1));
    overlay_->update();
}

void SceneView::dragGizmo(const QMouseEvent& event) {
    const auto motion = gizmo_.drag(lineAt(event.pos()), snappingOf(event.modifiers()));
    const auto& units = session_.display().units;
    const auto length = [&](double metres) { return QString::number(units.lengthOf(metres), 'f', 2); };
    const Vec3d now = gizmo_.target()->centre + motion.moveM + shared_.project->project.scene.origin;
    const QString unit = QString::fromUtf8(units.lengthUnit());
    QString reading = tr("%1, %2, %3 %4").arg(length(now.x), length(now.y), length(now.z), unit);
    if (motion.turnDeg != 0)
        reading += tr("\nturned %1°").arg(motion.turnDeg, 0, 'f', 0);
    else
        reading += tr("\nmoved %1, %2, %3 %4").arg(length(motion.moveM.x), length(motion.moveM.y), length(motion.moveM.z), unit);
    overlay_->setReading(reading, event.pos());
    emit dragged(motion, false);
}

void SceneView::endGizmo(bool keep) {
    overlay_->setReading({}, {});
    const auto motion = gizmo_.end();
    overlay_->update();
    if (keep && motion != GizmoMotion{}) return emit dragged(motion, true);
    aimGizmo();
    emit dragged({}, !keep);
}

void SceneView::placeSelected(const GizmoMotion& motion) {
    if (!gizmoTarget()) return;
    const auto& [thing, index] = session_.selection();
    const auto matrix = matrixOf(thing == Thing::Object ? pivotOf(index) : Vec3d(0, 0, 0), motion);
    if (thing == Thing::Object)
        room_->place(static_cast<std::uint32_t>(index), *matrix);
    else
        luminaires_->placeSelected(*matrix);
    keepMoving();
}

}  // namespace luxdeck::gui
