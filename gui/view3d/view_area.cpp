#include "gui/view3d/view_area.h"

#include "gui/session/probe.h"
#include "gui/session/surface_light.h"
#include "gui/view3d/legend_bar.h"
#include "gui/view3d/scene_view.h"

#include <QHBoxLayout>
#include <QPointer>
#include <QSplitter>
#include <QVector>

#include <algorithm>

namespace luxdeck::gui {

namespace {
constexpr int kReadMs = 100;  // between readings of the light under the cursor

/// Diffuse, where the whole object is of one matt material.
std::optional<double> reflectanceOf(const Scene& scene, const Selection& what) {
    if (what.thing != Thing::Object) return {};
    std::optional<std::uint32_t> material;
    for (const auto& mesh : scene.meshes) {
        if (mesh.object != what.index) continue;
        if (material && *material != mesh.material) return {};
        material = mesh.material;
    }
    if (!material) return {};
    const auto& m = scene.materials[*material];
    if (m.kind != MaterialKind::Matte || m.reflectancePattern >= 0 || m.reflectanceTexture.used()) return {};
    return luminance(m.reflectance, scene.weights);
}

}  // namespace

ViewArea::ViewArea(Session& session, QWidget* parent) : QWidget(parent), session_(session), rows_(new QSplitter(Qt::Vertical, this)), legend_(new LegendBar(session, this)) {
    setObjectName(QStringLiteral("viewArea"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(rows_, 1);
    layout->addWidget(legend_);
    rows_->setChildrenCollapsible(false);
    rest_.setSingleShot(true);
    rest_.setInterval(kReadMs);
    connect(&rest_, &QTimer::timeout, this, [this] {
        if (unread_) read();
    });
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

/// What the views draw of a project is made beside the window; until it is there they show what they showed.
void ViewArea::takeProject() {
    const auto project = session_.project();
    if (!project) return ready({});
    if (project == shared_.project) return refresh();
    session_.place.jobs.start(JobKind::Load, "Preparing the views", [area = QPointer<ViewArea>(this), project](const Progress&, const Jobs::Tell&) -> Jobs::Delivery {
        auto parts = std::make_shared<const SceneParts>(project->project.scene);
        const SharedScene shared{project, parts, RoomModel::of(project->project.scene, *parts)};
        return [area, shared] {
            if (area && area->session_.project() == shared.project) area->ready(shared);
        };
    });
    session_.place.tell(Change::Jobs);
}

void ViewArea::ready(const SharedScene& shared) {
    const bool another = !shared.project || !shared_.project || shared.project->project.file != shared_.project->project.file;
    shared_ = shared;
    if (another && shared_.project) lookFrom(Side::Iso);
    refresh();
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
        case Qt::Key_3: return lookFrom(Side::Right);
        case Qt::Key_7: return lookFrom(Side::Top);
        default: break;
    }
    if (!shared_.project || shared_.project->project.views.empty()) return;
    lastProjectView_ = lastProjectView_ % shared_.project->project.views.size();
    goTo(shared_.project->project.views[lastProjectView_]);
    ++lastProjectView_;
}

void ViewArea::dragged(GizmoMotion motion, bool done) {
    const auto [thing, index] = session_.selection();
    if (!shared_.project) return;
    if (thing == Thing::Object) {
        const auto& name = shared_.project->project.scene.objects[index].name;
        // What is in hand already stands elsewhere than the project has it.
        if (!taken_) taken_ = session_.furnishing.object() == name ? session_.furnishing.pose() : Pose{};
        motion = {motion.moveM + taken_->moveM, motion.turnDeg + taken_->turnDeg};
    }
    if (done) taken_.reset();
    for (auto* view : views_) view->placeSelected(motion);
    if (thing == Thing::Luminaire) emit luminaireDragged(static_cast<int>(index), motion.moveM, done);
    if (thing == Thing::Object) emit objectDragged(QString::fromStdString(shared_.project->project.scene.objects[index].name), motion.moveM, motion.turnDeg, done);
}

void ViewArea::showSelectedAt(const Vec3d& moveM, double turnDeg) {
    for (auto* view : views_) view->placeSelected({moveM, turnDeg});
}

void ViewArea::hovered(std::size_t index, const Picked& picked, QPoint at) {
    hover_ = {index, picked, at};
    unread_ = picked.any() && rest_.isActive();
    if (!unread_) read();
}

void ViewArea::read() {
    unread_ = false;
    rest_.start();
    if (hover_.view >= views_.size()) return;
    const auto reading = readingOf(views_[hover_.view]->settings(), hover_.picked);
    const bool light = reading.count(QLatin1Char('\n')) > 1;  // beside name and place
    views_[hover_.view]->setReading(light ? reading : QString(), hover_.at);
    emit probed(QString(reading).replace(QLatin1Char('\n'), QStringLiteral("  ·  ")));
}

/// Name, light where it is known, and place.
QString ViewArea::readingOf(const ViewSettings& view, const Picked& picked) const {
    if (!picked.any() || !shared_.project) return {};
    const auto& project = shared_.project->project;
    const auto& units = session_.display().units;
    const auto qt = [](const std::string& text) { return QString::fromStdString(text); };
    const auto index = picked.what.index;
    const Vec3d user = picked.point + project.scene.origin;
    QStringList lines;
    if (picked.what.thing == Thing::Object && index < project.scene.objects.size()) lines << qt(project.scene.objects[index].name);
    if (picked.what.thing == Thing::Luminaire && index < project.scene.luminaires.size()) lines << qt(project.scene.luminaires[index].name);
    if (picked.what.thing == Thing::Grid && index < project.grids.size()) {
        lines << qt(project.grids[index].name);
        const auto result = session_.solving.result();
        const auto light = [&](LightPart part) { return result && index < result->grids.size() ? lightAt(result->grids[index], part, user) : std::nullopt; };
        const auto shown = [&](double lux) { return units.illuminance(lux); };
        if (const auto total = light(LightPart::Total)) {
            lines << QStringLiteral("%1 %2").arg(qt(intervalText(shown(total->value), shown(total->ci95))), QString::fromUtf8(units.illuminanceUnit()));
            lines << tr("direct %1, indirect %2").arg(qt(numberText(shown(light(LightPart::Direct)->value))), qt(numberText(shown(light(LightPart::Indirect)->value))));
        }
        if (result && !session_.solving.current()) lines << tr("old: the project has changed since");
    }
    auto known = probe(session_, view, picked.point, picked.normal, reflectanceOf(project.scene, picked.what));
    if (picked.what.thing == Thing::Grid) known.nearest.reset();  // that is the one above
    if (known.fromVolume || known.nearest) lines << qt(known.text(units)).split(QStringLiteral("  ·  "));
    const auto length = [&](double metres) { return QString::number(units.lengthOf(metres), 'f', 2); };
    lines << QStringLiteral("%1, %2, %3 %4").arg(length(user.x), length(user.y), length(user.z), QString::fromUtf8(units.lengthUnit()));
    return lines.join(QLatin1Char('\n'));
}

}  // namespace luxdeck::gui
