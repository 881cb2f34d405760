#include "gui/view3d/view_area.h"

#include "gui/view3d/legend_bar.h"
#include "gui/view3d/scene_view.h"

#include <QHBoxLayout>
#include <QPointer>
#include <QSplitter>
#include <QVector>

#include <algorithm>

namespace luxdeck::gui {

ViewArea::ViewArea(Session& session, QWidget* parent) : QWidget(parent), session_(session), rows_(new QSplitter(Qt::Vertical, this)), legend_(new LegendBar(session, this)) {
    setObjectName(QStringLiteral("viewArea"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(rows_, 1);
    layout->addWidget(legend_);
    rows_->setChildrenCollapsible(false);
    session_.observe([area = QPointer<ViewArea>(this)](Change change) {
        if (area) area->heard(change);
    });
    arrange();
    takeProject();
}

ViewArea::~ViewArea() = default;

void ViewArea::heard(Change change) {
    switch (change) {
        case Change::Project: return takeProject();
        case Change::Display:
            if (views_.size() != session_.views().size()) arrange();
            return refresh();
        case Change::Solve:
        case Change::Volumes:
        case Change::Furniture:
        case Change::Selection: return refresh();
        default: return;
    }
}

void ViewArea::takeProject() {
    const auto project = session_.project();
    if (project == shared_.project) return refresh();
    const bool another = !project || !shared_.project || project->project.file != shared_.project->project.file;
    shared_.project = project;
    shared_.parts = project ? std::make_shared<const SceneParts>(project->project.scene) : nullptr;
    shared_.room = project ? RoomModel::of(project->project.scene, *shared_.parts) : nullptr;
    refresh();
    if (another && project) lookFrom(Side::Iso);
}

/// As many views as the session has: side by side, from three on in two rows.
void ViewArea::arrange() {
    const std::size_t count = session_.views().size();
    while (views_.size() > count) {
        delete views_.back();
        views_.pop_back();
    }
    const auto pose = views_.empty() ? CameraPose{} : views_.front()->pose();
    while (views_.size() < count) {
        const auto index = views_.size();
        auto* view = new SceneView(session_, shared_, index);
        view->setPose(pose);
        connect(view, &SceneView::moved, this, [this, index] { link(index); });
        connect(view, &SceneView::pressed, this, [this, index] { setActiveView(index); });
        connect(view, &SceneView::keyCommand, this, &ViewArea::keyCommand);
        connect(view, &SceneView::hovered, this, [this, index](const Picked& picked, QPoint at) { hovered(index, picked, at); });
        connect(view, &SceneView::dragged, this, &ViewArea::dragged);
        views_.push_back(view);
    }
    const std::size_t inFirstRow = count <= 2 ? count : 2;
    while (rows_->count() < (count > 2 ? 2 : 1)) {
        auto* row = new QSplitter(Qt::Horizontal);
        row->setChildrenCollapsible(false);
        rows_->addWidget(row);
    }
    for (std::size_t i = 0; i < count; ++i) {
        auto* row = static_cast<QSplitter*>(rows_->widget(i < inFirstRow ? 0 : 1));
        if (views_[i]->parentWidget() != row) row->addWidget(views_[i]);
    }
    if (count <= 2 && rows_->count() > 1) delete rows_->widget(1);
    for (int r = 0; r < rows_->count(); ++r) {
        auto* row = static_cast<QSplitter*>(rows_->widget(r));
        row->setSizes(QVector<int>(row->count(), 1000).toList());
    }
    active_ = std::min(active_, count - 1);
    setActiveView(active_);
}

void ViewArea::refresh() {
    Layer::Range all;
    for (auto* view : views_) {
        const auto range = view->lightRange();
        if (range.empty()) continue;
        all = all.empty() ? range : Layer::Range{std::min(all.low, range.low), std::max(all.high, range.high)};
    }
    scale_ = resolved(session_.display().legend, all.low, all.high);
    for (auto* view : views_) view->refresh(scale_);
    legend_->setVisible(!all.empty());
    const auto& settings = session_.views();
    legend_->show(scale_, std::all_of(settings.begin(), settings.end(), [](const ViewSettings& view) { return view.glyphs && view.order == 0; }));
}

void ViewArea::setActiveView(std::size_t index) {
    const bool changed = index != active_;
    active_ = std::min(index, views_.size() - 1);
    for (std::size_t i = 0; i < views_.size(); ++i) views_[i]->setFramed(views_.size() > 1 && i == active_);
    if (changed) emit activeChanged(static_cast<int>(active_));
}

void ViewArea::link(std::size_t from) {
    if (!session_.display().linkedCameras) return;
    for (std::size_t i = 0; i < views_.size(); ++i)
        if (i != from) views_[i]->setPose(views_[from]->pose());
}

CameraPose ViewArea::pose() const { return views_[active_]->pose(); }

void ViewArea::setPose(const CameraPose& pose) {
    views_[active_]->setPose(pose);
    link(active_);
}

void ViewArea::fit() {
    if (shared_.parts) setPose(fitted(pose(), views_[active_]->aspect(), shared_.parts->sceneBounds()));
}

void ViewArea::goTo(const View& view) {
    if (shared_.project) setPose(poseOf(view, shared_.project->project.scene));
}

void ViewArea::lookFrom(Side side) {
    if (shared_.parts && !shared_.parts->sceneBounds().isEmpty()) setPose(lookingFrom(side, views_[active_]->aspect(), shared_.parts->sceneBounds()));
}

View ViewArea::cameraAsView(const std::string& name) const {
    const auto& view = *views_[active_];
    return viewOf(view.pose(), shared_.project ? shared_.project->project.scene : Scene{}, name, view.width(), view.height());
}

QImage ViewArea::picture() {
    for (auto* view : views_) view->finish();
    return grab().toImage();
}

void ViewArea::keyCommand(int key) {
    switch (key) {
        case Qt::Key_F: return fit();
        case Qt::Key_Home: return lookFrom(Side::Iso);
        case Qt::Key_1: return lookFrom(Side::Front);
        case Qt::Key_3: return lookFrom(Side::Left);
        case Qt::Key_7: return lookFrom(Side::Top);
        default: break;
    }
    if (!shared_.project || shared_.project->project.views.empty()) return;
    lastProjectView_ = lastProjectView_ % shared_.project->project.views.size();
    goTo(shared_.project->project.views[lastProjectView_]);
    ++lastProjectView_;
}

void ViewArea::dragged(const GizmoMotion& motion, bool done) {
    for (auto* view : views_) view->placeSelected(motion);
    const auto& [thing, index] = session_.selection();
    if (thing == Thing::Luminaire) emit luminaireDragged(static_cast<int>(index), motion.moveM, done);
    if (thing == Thing::Object) emit objectDragged(QString::fromStdString(shared_.project->project.scene.objects[index].name), motion.moveM, motion.turnDeg, done);
}

void ViewArea::showSelectedAt(const Vec3d& moveM, double turnDeg) {
    for (auto* view : views_) view->placeSelected({moveM, turnDeg});
}

void ViewArea::hovered(std::size_t index, const Picked& picked, QPoint at) {
    static_cast<void>(index);
    static_cast<void>(at);
    if (!picked.any() || !shared_.project) return emit probed({});
    const auto& scene = shared_.project->project.scene;
    const auto& units = session_.display().units;
    const Vec3d user = picked.point + scene.origin;
    QString name;
    if (picked.what.thing == Thing::Object) name = QString::fromStdString(scene.objects[picked.what.index].name);
    if (picked.what.thing == Thing::Luminaire) name = QString::fromStdString(scene.luminaires[picked.what.index].name);
    if (picked.what.thing == Thing::Grid) name = QString::fromStdString(shared_.project->project.grids[picked.what.index].name);
    const auto metres = [&](double v) { return QString::fromStdString(numberText(units.lengthOf(v))); };
    emit probed(QStringLiteral("%1  ·  %2, %3, %4 %5").arg(name, metres(user.x), metres(user.y), metres(user.z), QString::fromUtf8(units.lengthUnit())));
}

}  // namespace luxdeck::gui
