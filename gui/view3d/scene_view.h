#pragma once

#include "gui/session/scene_pick.h"
#include "gui/view3d/gizmo.h"
#include "gui/view3d/layer.h"
#include "gui/view3d/navigator.h"
#include "gui/view3d/shared_scene.h"
#include "gui/view3d/view_colours.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QImage>
#include <QTimer>

#include <limits>
#include <memory>
#include <vector>

#include <vtkNew.h>
#include <vtkRenderer.h>

namespace luxdeck::gui {

class FurnitureLayer;
class GridLayer;
class LuminaireLayer;
class RoomLayer;
class ViewOverlay;

/// One view of the project: its layers in a renderer, a camera that mouse and keys move, texts over it. It renders when
/// something has changed, and only then. ViewArea makes, links and refreshes them.
class SceneView : public QVTKOpenGLNativeWidget {
    Q_OBJECT

public:
    /// index  of its settings among session.views()
    SceneView(Session& session, const SharedScene& shared, std::size_t index, QWidget* parent = nullptr);
    ~SceneView() override;

    /// What its layers would colour by.
    [[nodiscard]] Layer::Range lightRange();
    /// Brings all layers up to date with the session.
    void refresh(const ResolvedScale& scale);

    [[nodiscard]] const CameraPose& pose() const { return pose_; }
    /// Without a signal.
    void setPose(const CameraPose& pose);
    [[nodiscard]] double aspect() const;
    /// The view as it is on the screen.
    [[nodiscard]] QImage picture();
    /// What has been asked for is done at once, not when the event loop comes to it.
    void finish();
    /// Shows the selected object or luminaire this far from where the project has it; only there, until the project changes.
    void placeSelected(const GizmoMotion& motion);
    [[nodiscard]] const Gizmo& gizmo() const { return gizmo_; }
    void setFramed(bool framed);
    /// Words beside the cursor; empty: none.
    void setReading(const QString& reading, QPoint at);
    [[nodiscard]] const ViewSettings& settings() const;
    /// What is shown here, for picking.
    [[nodiscard]] Visible visible() const;
    /// What is under a place of the widget [pixels].
    [[nodiscard]] Picked pickedAt(QPoint at) const;
    /// Where a point of the scene (re-based) is seen [pixels]; none: behind the camera.
    [[nodiscard]] std::optional<QPointF> pixelOf(const Vec3d& point) const;

signals:
    /// The user has moved the camera.
    void moved();
    /// Pressed here.
    void pressed();
    /// F, Home, 1, 3, 7 or L.
    void keyCommand(int key);
    /// What is under the cursor has changed; nothing is picked when it has left.
    void hovered(const luxdeck::gui::Picked& picked, QPoint at);
    /// The selected thing is moved by its handles; `done` when the hand lets go.
    void dragged(const luxdeck::gui::GizmoMotion& motion, bool done);

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] Navigator::Place navigatorPlace();
    [[nodiscard]] ScreenPoint screenOf(QPoint at) const;
    void applyPalette();
    void applyPose();
    void requestRender();
    void renderNow();
    void keepMoving();
    void setMoving(bool moving);
    void comeToRest();
    void aimGizmo();
    /// What is in hand stands where the hand is.
    void placeInHand();
    [[nodiscard]] bool inHand(std::size_t object) const;
    [[nodiscard]] Vec3d pivotOf(std::size_t object) const;
    [[nodiscard]] std::optional<Gizmo::Target> gizmoTarget() const;
    void dragGizmo(const QMouseEvent& event);
    void endGizmo(bool keep);
    [[nodiscard]] SightLine lineAt(QPoint at) const { return sightLine(pose_, aspect(), screenOf(at)); }
    void reannotate();
    void select(QPoint at);
    [[nodiscard]] QString hint() const;

    Session& session_;
    const SharedScene& shared_;
    std::size_t index_;
    CameraPose pose_;
    vtkNew<vtkRenderer> renderer_;
    RoomLayer* room_ = nullptr;              // of layers_
    LuminaireLayer* luminaires_ = nullptr;
    GridLayer* grids_ = nullptr;
    FurnitureLayer* furniture_ = nullptr;
    std::vector<std::unique_ptr<Layer>> layers_;
    ViewOverlay* overlay_;
    Gizmo gizmo_;
    std::unique_ptr<Navigator> navigator_;
    QTimer render_, rest_;
    bool moving_ = false;                    // drawn without what takes long
    qint64 wholeFrameMs_ = std::numeric_limits<qint64>::max();  // of the last frame that was drawn whole
    QPoint lastClick_{-100, -100};
    std::size_t clickDepth_ = 0;             // which of the things under the cursor was picked last
};

}  // namespace luxdeck::gui
