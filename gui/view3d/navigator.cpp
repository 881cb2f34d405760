#include "gui/view3d/navigator.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck::gui {

namespace {

constexpr int kFrameMs = 33;
constexpr int kDragFromPixels = 4;
constexpr int kHoldFromMs = 180;          // a button held longer than this is not a click
constexpr double kTurnDegPerPixel = 0.35;
constexpr double kLookDegPerPixel = 0.2;
constexpr double kWheelFactor = 0.86;     // of the distance, a notch
constexpr double kCloserPerFrame = 0.9;   // Ward & Simmons: "10% closer per frame"
constexpr double kEyeHeightM = 1.6;
constexpr double kHurry = 3;

bool isWalkKey(int key) {
    static const QSet<int> keys{Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E, Qt::Key_Up, Qt::Key_Down, Qt::Key_Left, Qt::Key_Right};
    return keys.contains(key);
}

/// Upright on the floor, with perspective, inside the room when it stood outside.
CameraPose walking(CameraPose pose, const Box3& bounds) {
    pose.parallel = false;
    pose.fovDeg = std::max(pose.fovDeg, 55.0);
    if (std::abs(pose.direction.z) > 0.5) {
        Vec3d level = std::abs(pose.direction.z) < 0.99 ? pose.direction : pose.up;
        level.z = -0.1;
        pose.direction = level.normalized();
        pose.up = Vec3d(0, 0, 1);
    }
    pose = upright(pose);
    if (bounds.isEmpty()) return pose;
    if (!bounds.intersects(Vec3(pose.position))) pose.position = Vec3d(bounds.center()) - pose.direction * (0.25 * double{bounds.size().length()} * 0.5);
    pose.position.z = std::min(double{bounds.min.z} + kEyeHeightM, 0.5 * (double{bounds.min.z} + double{bounds.max.z}) + 0.5);
    return pose;
}

}  // namespace

Navigator::Navigator(Place place) : place_(std::move(place)) {
    frames_.setInterval(kFrameMs);
    QObject::connect(&frames_, &QTimer::timeout, [this] { frame(); });
    wheelRest_.setSingleShot(true);
    wheelRest_.setInterval(150);
    QObject::connect(&wheelRest_, &QTimer::timeout, [this] { place_.rested(); });
}

void Navigator::setNavigation(Navigation navigation) {
    if (navigation == navigation_) return;
    stop();
    navigation_ = navigation;
    if (navigation == Navigation::Walk) place_.move(walking(place_.pose(), place_.bounds()));
}

Vec3d Navigator::anchorAt(QPoint at) const {
    const auto screen = place_.screen(at);
    if (const auto under = place_.under(screen)) return *under;
    // Nothing there: as far as the middle of the scene is.
    const auto pose = place_.pose();
    const auto bounds = place_.bounds();
    const double depth = bounds.isEmpty() ? 5 : std::max(depthOf(pose, Vec3d(bounds.center())), 0.5);
    const auto line = sightLine(pose, place_.aspect(), screen);
    return line.origin + line.direction * (depth / std::max(line.direction.dot(pose.direction), 0.1));
}

void Navigator::press(const QMouseEvent& event) {
    if (button_ != Qt::NoButton) return;
    start_ = last_ = event.pos();
    button_ = event.button();
    shift_ = (event.modifiers() & Qt::ShiftModifier) != 0;
    dragging_ = false;
    pressed_.start();
    anchor_ = anchorAt(event.pos());
    if (navigation_ == Navigation::Holodeck && !shift_ && button_ != Qt::MiddleButton) {
        since_.start();
        frames_.start();
    }
}

void Navigator::drag(const QMouseEvent& event) {
    if (button_ == Qt::NoButton) return;
    if (!dragging_ && (event.pos() - start_).manhattanLength() < kDragFromPixels) return;
    dragging_ = true;
    const QPoint by = event.pos() - last_;
    if (navigation_ == Navigation::Walk)
        dragLook(by);
    else if (navigation_ == Navigation::Orbit || button_ == Qt::MiddleButton)
        dragOrbit(event);
    else if (shift_)
        dragLook(by);
    last_ = event.pos();
}

void Navigator::dragOrbit(const QMouseEvent& event) {
    const auto pose = place_.pose();
    const QPoint by = event.pos() - last_;
    if (navigation_ == Navigation::Orbit && (shift_ || button_ == Qt::RightButton)) return place_.move(panned(pose, place_.aspect(), anchor_, place_.screen(event.pos())));
    place_.move(orbited(pose, anchor_, -kTurnDegPerPixel * by.x(), -kTurnDegPerPixel * by.y()));
}

void Navigator::dragLook(QPoint by) {
    // The scene follows the hand.
    place_.move(lookedAround(place_.pose(), kLookDegPerPixel * by.x(), kLookDegPerPixel * by.y()));
}

bool Navigator::release(const QMouseEvent& event) {
    if (event.button() != button_) return false;
    const bool held = navigation_ == Navigation::Holodeck && pressed_.elapsed() > kHoldFromMs;
    const bool click = !dragging_ && !held;
    button_ = Qt::NoButton;
    dragging_ = false;
    if (navigation_ == Navigation::Holodeck) frames_.stop();
    place_.rested();
    return click;
}

void Navigator::wheel(const QWheelEvent& event) {
    const double notches = event.angleDelta().y() / 120.0;
    if (notches == 0) return;
    if (navigation_ == Navigation::Walk) {
        paceMs_ = std::clamp(paceMs_ * std::pow(1.2, notches), 0.2, 20.0);
        return place_.move(place_.pose());
    }
    const auto at = event.position().toPoint();
    place_.move(approached(place_.pose(), place_.aspect(), anchorAt(at), std::pow(kWheelFactor, notches)));
    wheelRest_.start();
}

bool Navigator::keyDown(const QKeyEvent& event) {
    const bool command = (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
    if (navigation_ != Navigation::Walk || command || !isWalkKey(event.key())) return false;
    shift_ = (event.modifiers() & Qt::ShiftModifier) != 0;
    if (event.isAutoRepeat()) return true;
    keys_.insert(event.key());
    if (!frames_.isActive()) {
        since_.start();
        frames_.start();
    }
    return true;
}

bool Navigator::keyUp(const QKeyEvent& event) {
    shift_ = (event.modifiers() & Qt::ShiftModifier) != 0;
    if (event.isAutoRepeat()) return keys_.contains(event.key());
    if (!keys_.remove(event.key())) return false;
    if (keys_.isEmpty()) stop();
    return true;
}

void Navigator::stop() {
    keys_.clear();
    frames_.stop();
    button_ = Qt::NoButton;
    dragging_ = false;
    place_.rested();
}

void Navigator::frame() {
    const double seconds = std::min(since_.restart() / 1000.0, 0.2);
    if (navigation_ == Navigation::Walk)
        walkFrame(seconds);
    else
        holodeckFrame();
}

void Navigator::walkFrame(double seconds) {
    const auto held = [&](int key, int other) { return keys_.contains(key) || keys_.contains(other) ? 1.0 : 0.0; };
    const double step = paceMs_ * (shift_ ? kHurry : 1) * seconds;
    place_.move(walked(place_.pose(), step * (held(Qt::Key_W, Qt::Key_Up) - held(Qt::Key_S, Qt::Key_Down)), step * (held(Qt::Key_D, Qt::Key_Right) - held(Qt::Key_A, Qt::Key_Left)),
                       step * (held(Qt::Key_E, Qt::Key_E) - held(Qt::Key_Q, Qt::Key_Q))));
}

void Navigator::holodeckFrame() {
    if (pressed_.elapsed() <= kHoldFromMs) return;
    const double factor = button_ == Qt::RightButton ? 1 / kCloserPerFrame : kCloserPerFrame;
    place_.move(approached(place_.pose(), place_.aspect(), anchorAt(last_), factor));
}

}  // namespace luxdeck::gui
