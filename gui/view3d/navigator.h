#pragma once

#include "gui/session/camera_motion.h"
#include "gui/session/display.h"

#include <QElapsedTimer>
#include <QPoint>
#include <QSet>
#include <QString>
#include <QTimer>

#include <functional>
#include <optional>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace luxdeck::gui {

/// Turns what mouse and keys do in a view into motion of its camera, in the way that the user has chosen (Navigation).
///
/// Orbit     drag turns about what is under the cursor; right drag, or with Shift, shifts; the wheel goes to the cursor
/// Walk      drag looks around; W A S D or arrows walk, Q E go down and up, Shift hurries, the wheel sets the pace
/// Holodeck  left held goes 10 % closer a frame to what is under the cursor, right backs away, middle orbits it, Shift and
///           drag rotates (Ward & Simmons 1999, 2.4.1)
class Navigator {
public:
    /// What it moves, and what it has to know of the view.
    struct Place {
        std::function<CameraPose()> pose;
        std::function<void(const CameraPose&)> move;
        std::function<double()> aspect;
        std::function<ScreenPoint(QPoint)> screen;
        std::function<std::optional<Vec3d>(ScreenPoint)> under;  ///< the point of the scene there
        std::function<Box3()> bounds;                            ///< of the scene
        std::function<void()> rested;                            ///< motion has ended
    };
    explicit Navigator(Place place);

    void setNavigation(Navigation navigation);
    void press(const QMouseEvent& event);
    void drag(const QMouseEvent& event);
    /// Returns whether the button was only clicked, not dragged or held.
    bool release(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    /// Returns whether the key means something.
    bool keyDown(const QKeyEvent& event);
    bool keyUp(const QKeyEvent& event);
    void stop();
    [[nodiscard]] bool moving() const { return dragging_ || frames_.isActive(); }
    /// How fast walking is [m/s].
    [[nodiscard]] double paceMs() const { return paceMs_; }

private:
    void dragOrbit(const QMouseEvent& event);
    void dragLook(QPoint by);
    void frame();
    void walkFrame(double seconds);
    void holodeckFrame();
    [[nodiscard]] Vec3d anchorAt(QPoint at) const;

    Place place_;
    Navigation navigation_ = Navigation::Orbit;
    QTimer frames_, wheelRest_;
    QElapsedTimer since_, pressed_;
    QPoint start_, last_;
    Qt::MouseButton button_ = Qt::NoButton;
    bool shift_ = false, dragging_ = false;
    Vec3d anchor_{0, 0, 0};
    QSet<int> keys_;
    double paceMs_ = 1.4;
};

}  // namespace luxdeck::gui
