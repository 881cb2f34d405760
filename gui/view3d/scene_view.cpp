#include "gui/view3d/scene_view.h"

#include "gui/view3d/furniture_layer.h"
#include "gui/view3d/glyph_layer.h"
#include "gui/view3d/grid_layer.h"
#include "gui/view3d/lattice_layer.h"
#include "gui/view3d/luminaire_layer.h"
#include "gui/view3d/room_layer.h"
#include "gui/view3d/slice_layer.h"
#include "gui/view3d/view_overlay.h"

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>

namespace luxdeck::gui {

namespace {

constexpr int kSamePlacePixels = 3;
constexpr int kRestMs = 200;      // after the last motion all is drawn again, and texts looked through for what hides them
constexpr int kSamples = 4;       // a pixel, when nothing moves
constexpr qint64 kSmoothMs = 40;  // a frame; what takes longer is not drawn whole while it moves

}  // namespace

SceneView::SceneView(Session& session, const SharedScene& shared, std::size_t index, QWidget* parent)
    : QVTKOpenGLNativeWidget(parent), session_(session), shared_(shared), index_(index), overlay_(new ViewOverlay(this)), gizmo_([this](const Vec3d& p) { return overlay_->pixelOf(p); }) {
    setObjectName(QStringLiteral("sceneView%1").arg(index + 1));
    setAccessibleName(tr("View %1 of the room").arg(index + 1));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);

    vtkNew<vtkGenericOpenGLRenderWindow> window;
    window->SetMultiSamples(kSamples);
    setRenderWindow(window);
    renderer_->SetGradientBackground(true);
    window->AddRenderer(renderer_);

    auto room = std::make_unique<RoomLayer>(*renderer_, shared_);
    auto luminaires = std::make_unique<LuminaireLayer>(*renderer_, shared_);
    room_ = room.get();
    auto grids = std::make_unique<GridLayer>(*renderer_, shared_);
    luminaires_ = luminaires.get();
    grids_ = grids.get();
    layers_.push_back(std::move(room));
    layers_.push_back(std::move(grids));
    layers_.push_back(std::move(luminaires));
    auto furniture = std::make_unique<FurnitureLayer>(*renderer_);
    furniture_ = furniture.get();
    layers_.push_back(std::move(furniture));
    layers_.push_back(std::make_unique<LatticeLayer>(*renderer_));
    layers_.push_back(std::make_unique<GlyphLayer>(*renderer_));
    layers_.push_back(std::make_unique<SliceLayer>(*renderer_));

    overlay_->setPainter([this](QPainter& painter) { gizmo_.paint(painter, ViewColours::of(palette())); });
    navigator_ = std::make_unique<Navigator>(navigatorPlace());
    render_.setSingleShot(true);
    render_.setInterval(0);
    connect(&render_, &QTimer::timeout, this, &SceneView::renderNow);
    rest_.setSingleShot(true);
    rest_.setInterval(kRestMs);
    connect(&rest_, &QTimer::timeout, this, &SceneView::comeToRest);
    applyPalette();
}

SceneView::~SceneView() = default;

Navigator::Place SceneView::navigatorPlace() {
    Navigator::Place place;
    place.pose = [this] { return pose_; };
    place.move = [this](const CameraPose& pose) {
        setPose(pose);
        emit moved();
    };
    place.aspect = [this] { return aspect(); };
    place.screen = [this](QPoint at) { return screenOf(at); };
    place.under = [this](ScreenPoint at) -> std::optional<Vec3d> {
        const auto picked = pick(visible(), sightLine(pose_, aspect(), at));
        return picked.any() ? std::optional<Vec3d>(picked.point) : std::nullopt;
    };
    place.bounds = [this] { return shared_.parts ? shared_.parts->sceneBounds() : Box3(); };
    place.rested = [this] { rest_.start(); };
    return place;
}

const ViewSettings& SceneView::settings() const { return session_.views()[std::min(index_, session_.views().size() - 1)]; }

double SceneView::aspect() const { return static_cast<double>(std::max(width(), 1)) / std::max(height(), 1); }

ScreenPoint SceneView::screenOf(QPoint at) const {
    return {2.0 * (at.x() + 0.5) / std::max(width(), 1) - 1, 1 - 2.0 * (at.y() + 0.5) / std::max(height(), 1)};
}

std::optional<QPointF> SceneView::pixelOf(const Vec3d& point) const { return overlay_->pixelOf(point); }

Visible SceneView::visible() const {
    Visible visible;
    const auto& view = settings();
    visible.project = shared_.project.get();
    visible.parts = shared_.parts.get();
    visible.result = session_.solving.result().get();
    visible.hiddenSides = view.hideCeiling && shared_.parts ? shared_.parts->sidesInTheWay(pose_) : 0;
    visible.surfaces = view.surfaces != SurfaceLook::Hidden;
    visible.luminaires = view.luminaires;
    visible.grids = view.grids;
    if (session_.selection().thing == Thing::Grid) visible.onlyGrid = session_.selection().index;
    visible.section = view.section;
    return visible;
}

Picked SceneView::pickedAt(QPoint at) const { return pick(visible(), lineAt(at)); }

Layer::Range SceneView::lightRange() {
    Layer::Range all;
    for (const auto& layer : layers_) {
        const auto range = layer->lightRange(session_, settings());
        if (range.empty()) continue;
        all = all.empty() ? range : Layer::Range{std::min(all.low, range.low), std::max(all.high, range.high)};
    }
    return all;
}

void SceneView::refresh(const ResolvedScale& scale) {
    bool changed = false;
    for (const auto& layer : layers_) changed |= layer->update(session_, settings(), scale);
    changed |= room_->hideSides(visible().hiddenSides);
    placeInHand();
    navigator_->setNavigation(session_.display().navigation);
    overlay_->setHint(hint());
    aimGizmo();
    if (!changed) return;
    renderer_->ResetCameraClippingRange();
    requestRender();
    reannotate();
}

void SceneView::setPose(const CameraPose& pose) {
    pose_ = pose;
    room_->hideSides(visible().hiddenSides);
    overlay_->setPose(pose_);
    overlay_->setHint(hint());
    aimGizmo();
    applyPose();
    keepMoving();
}

/// Draws less until nothing has moved for a while, where a whole frame takes long.
void SceneView::keepMoving() {
    setMoving(wholeFrameMs_ > kSmoothMs);
    requestRender();
    rest_.start();
}

void SceneView::setMoving(bool moving) {
    if (moving == moving_) return;
    moving_ = moving;
    renderWindow()->SetMultiSamples(moving ? 0 : kSamples);
    for (const auto& layer : layers_) layer->setMoving(moving);
}

void SceneView::comeToRest() {
    if (moving_) requestRender();
    setMoving(false);
    reannotate();
}

void SceneView::applyPose() {
    auto* camera = renderer_->GetActiveCamera();
    const Vec3d focus = pose_.position + pose_.direction;
    camera->SetPosition(pose_.position.x, pose_.position.y, pose_.position.z);
    camera->SetFocalPoint(focus.x, focus.y, focus.z);
    camera->SetViewUp(pose_.up.x, pose_.up.y, pose_.up.z);
    camera->SetViewAngle(pose_.fovDeg);
    camera->SetParallelProjection(pose_.parallel ? 1 : 0);
    camera->SetParallelScale(pose_.heightM / 2);
    renderer_->ResetCameraClippingRange();
}

void SceneView::requestRender() {
    if (!render_.isActive()) render_.start();
}

void SceneView::renderNow() {
    if (!isVisible() || !isValid()) return;
    applyPose();
    QElapsedTimer clock;
    clock.start();
    renderWindow()->Render();
    if (moving_) return;
    renderWindow()->WaitForCompletion();
    wholeFrameMs_ = clock.elapsed();
}

/// Texts of all layers, and which of them nothing hides.
void SceneView::reannotate() {
    std::vector<Annotation> annotations;
    for (const auto& layer : layers_) layer->annotate(annotations);
    std::vector<Vec3d> points;
    points.reserve(annotations.size());
    for (const auto& annotation : annotations) points.push_back(annotation.at);
    std::vector<std::uint8_t> seen;
    seePoints(visible(), pose_, points, seen);
    overlay_->setAnnotations(std::move(annotations), std::move(seen));
}

void SceneView::finish() {
    if (rest_.isActive()) {
        rest_.stop();
        comeToRest();
    }
    render_.stop();
    renderNow();
}

QImage SceneView::picture() {
    finish();
    return grab().toImage();
}

void SceneView::setReading(const QString& reading, QPoint at) { overlay_->setReading(reading, at); }

void SceneView::setFramed(bool framed) { overlay_->setFramed(framed); }

QString SceneView::hint() const {
    switch (session_.display().navigation) {
        case Navigation::Orbit: return {};
        case Navigation::Walk: return tr("W A S D walk · drag looks around · wheel sets the pace: %1 m/s · Shift hurries").arg(navigator_->paceMs(), 0, 'f', 1);
        case Navigation::Holodeck: return tr("Hold left to come closer · right to back away · middle to orbit · Shift and drag to turn");
    }
    return {};
}

void SceneView::applyPalette() {
    const auto colours = ViewColours::of(palette());
    const auto top = rgbOf(colours.backgroundTop), bottom = rgbOf(colours.backgroundBottom);
    renderer_->SetBackground(bottom[0], bottom[1], bottom[2]);
    renderer_->SetBackground2(top[0], top[1], top[2]);
    room_->setColours(colours);
    luminaires_->setColours(colours);
    grids_->setColours(colours);
    overlay_->setColours(colours);
    requestRender();
}

/// VTK's own interaction is left out: all motion is the Navigator's.
bool SceneView::event(QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonRelease:
        case QEvent::MouseButtonDblClick:
        case QEvent::MouseMove:
        case QEvent::Wheel:
        case QEvent::KeyPress:
        case QEvent::KeyRelease:
        case QEvent::Enter:
        case QEvent::Leave:
        case QEvent::FocusIn:
        case QEvent::FocusOut: return QOpenGLWidget::event(event);
        default: return QVTKOpenGLNativeWidget::event(event);
    }
}

void SceneView::mousePressEvent(QMouseEvent* event) {
    emit pressed();
    const auto handle = event->button() == Qt::LeftButton ? gizmo_.handleAt(event->pos()) : Handle::None;
    if (handle == Handle::None) return navigator_->press(*event);
    gizmo_.begin(handle, lineAt(event->pos()));
    overlay_->update();
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    if (gizmo_.dragging()) return dragGizmo(*event);
    navigator_->drag(*event);
    if (navigator_->moving()) return overlay_->setReading({}, {});
    const auto handle = gizmo_.handleAt(event->pos());
    if (gizmo_.setHot(handle)) overlay_->update();
    setCursor(handle == Handle::None ? Qt::ArrowCursor : Qt::OpenHandCursor);
    emit hovered(pickedAt(event->pos()), event->pos());
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    if (gizmo_.dragging() && event->button() == Qt::LeftButton) return endGizmo(true);
    if (navigator_->release(*event) && event->button() == Qt::LeftButton) select(event->pos());
}

/// The first thing under the cursor; clicked again at the same place, what lies behind it.
void SceneView::select(QPoint at) {
    const auto things = pickAll(visible(), lineAt(at));
    const bool again = (at - lastClick_).manhattanLength() <= kSamePlacePixels;
    clickDepth_ = again ? clickDepth_ + 1 : 0;
    lastClick_ = at;
    session_.select(things.empty() ? Selection{} : things[clickDepth_ % things.size()].what);
}

void SceneView::wheelEvent(QWheelEvent* event) {
    navigator_->wheel(*event);
    event->accept();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    if (gizmo_.dragging() && event->key() == Qt::Key_Escape) return endGizmo(false);
    if (navigator_->keyDown(*event)) return;
    const auto commands = {Qt::Key_F, Qt::Key_Home, Qt::Key_1, Qt::Key_3, Qt::Key_7, Qt::Key_L};
    if (event->modifiers() == Qt::NoModifier && std::find(commands.begin(), commands.end(), event->key()) != commands.end()) {
        emit keyCommand(event->key());
        return;
    }
    QVTKOpenGLNativeWidget::keyPressEvent(event);
}

void SceneView::keyReleaseEvent(QKeyEvent* event) {
    if (!navigator_->keyUp(*event)) QVTKOpenGLNativeWidget::keyReleaseEvent(event);
}

void SceneView::focusOutEvent(QFocusEvent* event) {
    navigator_->stop();
    QVTKOpenGLNativeWidget::focusOutEvent(event);
}

void SceneView::leaveEvent(QEvent* event) {
    emit hovered({}, {});
    QVTKOpenGLNativeWidget::leaveEvent(event);
}

void SceneView::resizeEvent(QResizeEvent* event) {
    QVTKOpenGLNativeWidget::resizeEvent(event);
    overlay_->setGeometry(rect());
    aimGizmo();
    keepMoving();
}

void SceneView::changeEvent(QEvent* event) {
    QVTKOpenGLNativeWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) applyPalette();
}

}  // namespace luxdeck::gui
