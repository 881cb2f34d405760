#pragma once

#include "gui/session/camera_motion.h"
#include "gui/session/scene_pick.h"
#include "gui/session/session.h"
#include "gui/view3d/light_colours.h"
#include "gui/view3d/shared_scene.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <optional>
#include <vector>

class QSplitter;

namespace luxdeck::gui {

class LegendBar;
class SceneView;
struct GizmoMotion;

/// The middle of the window: one to four views of the project (as many as session.views()), and the one legend that they
/// share. It follows the session by itself; what the user picks in it is session.selection().
///
/// prepareGraphics() has to be called before the QApplication is made.
class ViewArea : public QWidget {
    Q_OBJECT

public:
    explicit ViewArea(Session& session, QWidget* parent = nullptr);
    ~ViewArea() override;

    /// The view that commands are for; framed where there are several.
    [[nodiscard]] std::size_t activeView() const { return active_; }
    void setActiveView(std::size_t index);

    /// The whole project in the active view (in all of them where cameras are linked), looked at in the same direction.
    void fit();
    /// A view of the project, as the renderer has it.
    void goTo(const View& view);
    void lookFrom(Side side);
    /// The active view as one of the project's, in user coordinates, in the size that it has on the screen.
    [[nodiscard]] View cameraAsView(const std::string& name) const;
    [[nodiscard]] CameraPose pose() const;
    void setPose(const CameraPose& pose);

    /// Shows the selected object or luminaire so far from where the project has it, until the project changes; nowhere else:
    /// back where it was (an edit that was refused).
    void showSelectedAt(const Vec3d& moveM = {0, 0, 0}, double turnDeg = 0);

    /// All views and the legend as they are on the screen.
    [[nodiscard]] QImage picture();
    [[nodiscard]] SceneView& view(std::size_t index) { return *views_[index]; }
    [[nodiscard]] std::size_t viewCount() const { return views_.size(); }
    /// The scale that all views colour by.
    [[nodiscard]] const ResolvedScale& scale() const { return scale_; }

signals:
    /// What is under the cursor, in words with units; empty when there is nothing.
    void probed(const QString& reading);
    void activeChanged(int index);
    /// The selected piece of furniture is moved by its handles: so far from where the project has it, turned about its pivot
    /// (as Pose). Views show it there already; `done` when the hand lets go. No motion: it was put back.
    void objectDragged(const QString& name, const luxdeck::Vec3d& moveM, double turnDeg, bool done);
    /// The same of a luminaire, by its index in the scene.
    void luminaireDragged(int index, const luxdeck::Vec3d& moveM, bool done);

private:
    void heard(Change change);
    void takeProject();
    void arrange();
    void refresh();
    void link(std::size_t from);
    void keyCommand(int key);
    void dragged(GizmoMotion motion, bool done);
    void ready(const SharedScene& shared);
    [[nodiscard]] QString readingOf(const ViewSettings& view, const Picked& picked) const;
    /// At most ten times a second.
    void hovered(std::size_t index, const Picked& picked, QPoint at);
    void read();

    Session& session_;
    SharedScene shared_;
    std::vector<SceneView*> views_;
    QSplitter* rows_;
    LegendBar* legend_;
    ResolvedScale scale_;
    struct Hover {
        std::size_t view = 0;
        Picked picked;
        QPoint at;
    } hover_;
    QTimer rest_;                 // of the reading
    bool unread_ = false;         // the cursor has moved on since
    std::size_t active_ = 0, lastProjectView_ = 0;
    std::optional<Pose> taken_;   // of the object in hand when the drag began
};

}  // namespace luxdeck::gui
