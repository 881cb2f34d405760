#include "gui/panels/volume_show.h"

#include "gui/panels/text.h"
#include "gui/session/scene_pick.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

struct Direction {
    const char* name;
    Vec3d normal;
};
const Direction kSlices[] = {{QT_TR_NOOP("Horizontal"), {0, 0, 1}}, {QT_TR_NOOP("Across, west to east"), {1, 0, 0}}, {QT_TR_NOOP("Along, south to north"), {0, 1, 0}}};
const Direction kFacings[] = {{QT_TR_NOOP("up"), {0, 0, 1}},      {QT_TR_NOOP("down"), {0, 0, -1}},  {QT_TR_NOOP("to the east"), {1, 0, 0}},
                              {QT_TR_NOOP("to the west"), {-1, 0, 0}}, {QT_TR_NOOP("to the north"), {0, 1, 0}}, {QT_TR_NOOP("to the south"), {0, -1, 0}}};
constexpr int kOffsetSteps = 400;           // of the slider, over the scene's extent
constexpr double kRadiusStepM = 0.005;
constexpr double kWorkingPlaneM = 0.8;      // over the floor: where a horizontal slice begins

Box3 boundsOf(const Session& session) { return session.project() ? session.project()->project.scene.bounds() : Box3(); }

template <std::size_t N>
int indexOf(const Direction (&all)[N], const Vec3d& normal) {
    const auto at = std::find_if(std::begin(all), std::end(all), [&](const auto& d) { return d.normal == normal; });
    return at == std::end(all) ? -1 : static_cast<int>(at - std::begin(all));
}

QSlider* slider(QWidget* parent, const char* name, int low, int high, const QString& tip) {
    auto* made = new QSlider(Qt::Horizontal, parent);
    made->setObjectName(QString::fromLatin1(name));
    made->setRange(low, high);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    return made;
}

QLayout* beside(QWidget* wide, QWidget* narrow) {
    auto* row = new QHBoxLayout;
    row->addWidget(wide, 1);
    row->addWidget(narrow);
    return row;
}

}  // namespace

VolumeShow::VolumeShow(Session& session, QWidget* parent) : QWidget(parent), session_(session), title_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    title_->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(title_);
    for (auto* part : {whose(), spheres(), slices(), sideBySide()}) layout->addWidget(part);
    session_.observe([panel = QPointer<VolumeShow>(this)](Change change) {
        if (panel && (change == Change::Display || change == Change::Project || change == Change::Volumes)) panel->refresh();
    });
    refresh();
}

QCheckBox* VolumeShow::addSwitch(const QString& text, const char* name, const QString& tip, Switch member) {
    auto* box = new QCheckBox(text, this);
    box->setObjectName(QString::fromLatin1(name));
    box->setToolTip(tip);
    connect(box, &QCheckBox::toggled, this, [this, member](bool on) { change([=](ViewSettings& view) { view.*member = on; }); });
    switches_.emplace_back(box, member);
    return box;
}

QWidget* VolumeShow::whose() {
    auto* box = new QWidget(this);
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    volume_ = new QComboBox(box);
    volume_->setObjectName(QStringLiteral("viewVolume"));
    volume_->setToolTip(tr("Each view may show another volume"));
    connect(volume_, qOverload<int>(&QComboBox::activated), this, [this](int index) { change([=, this](ViewSettings& view) { view.volume = volume_->itemData(index).toString().toStdString(); }); });
    part_ = new QComboBox(box);
    part_->setObjectName(QStringLiteral("volumePart"));
    part_->addItems({tr("Total"), tr("Direct"), tr("Indirect")});
    part_->setToolTip(tr("Light straight from luminaires and sky, light that was reflected, or both"));
    connect(part_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) { change([=](ViewSettings& view) { view.part = static_cast<LightPart>(index); }); });
    form->addRow(tr("Volume"), volume_);
    form->addRow(tr("Part"), part_);
    return box;
}

QWidget* VolumeShow::spheres() {
    auto* group = new QGroupBox(tr("Vertices"), this);
    auto* form = new QFormLayout(group);
    form->addRow(addSwitch(tr("Spheres of light"), "showGlyphs",
                           tr("At each vertex: in every direction, what a surface there that faces that way gets.\nSmall grey crosses: vertices inside solids, which nothing is known of"), &ViewSettings::glyphs));
    order_ = slider(group, "volumeOrder", 0, 100, tr("0: what is seen in that direction; 1: what a matte surface gets; more: what glossier and glossier ones get"));
    orderText_ = new QLabel(group);
    orderText_->setObjectName(QStringLiteral("volumeOrderText"));
    connect(order_, &QSlider::valueChanged, this, [this](int value) { change([=](ViewSettings& view) { view.order = value; }); });
    radius_ = slider(group, "glyphRadius", 2, 60, tr("Radius of the spheres"));
    radiusText_ = new QLabel(group);
    connect(radius_, &QSlider::valueChanged, this, [this](int value) { change([=](ViewSettings& view) { view.glyphRadiusM = value * kRadiusStepM; }); });
    form->addRow(tr("Shows"), beside(order_, orderText_));
    form->addRow(tr("Radius"), beside(radius_, radiusText_));
    form->addRow(addSwitch(tr("First-level grid"), "showFirstLevel", tr("Cells of the whole volume"), &ViewSettings::firstLevelGrid));
    form->addRow(addSwitch(tr("Second-level grid"), "showSecondLevel", tr("Finer cells around furniture and walls, or where light changes"), &ViewSettings::secondLevelGrid));
    return group;
}

QWidget* VolumeShow::slices() {
    auto* group = new QGroupBox(tr("Illuminance in the room"), this);
    auto* form = new QFormLayout(group);
    slice_ = new QCheckBox(tr("Slice"), group);
    slice_->setObjectName(QStringLiteral("sliceOn"));
    slice_->setToolTip(tr("A plane through the volume in false colour. Walls stop interpolation; where nothing is known it is left empty"));
    connect(slice_, &QCheckBox::toggled, this, &VolumeShow::switchSlice);
    axis_ = new QComboBox(group);
    axis_->setObjectName(QStringLiteral("sliceAxis"));
    for (const auto& slice : kSlices) axis_->addItem(tr(slice.name));
    connect(axis_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
        change([=](ViewSettings& view) {
            view.slice.normal = kSlices[index].normal;
            view.slice.offsetM = 0;
        });
    });
    offset_ = slider(group, "sliceOffset", -kOffsetSteps / 2, kOffsetSteps / 2, tr("Where the slice lies"));
    offsetText_ = new QLabel(group);
    offsetText_->setObjectName(QStringLiteral("sliceOffsetText"));
    connect(offset_, &QSlider::valueChanged, this, [this](int value) {
        change([=, this](ViewSettings& view) { view.slice.offsetM = sectionReachM(boundsOf(session_), view.slice.normal) * value * 2 / kOffsetSteps; });
    });
    facing_ = new QComboBox(group);
    facing_->setObjectName(QStringLiteral("sliceFacing"));
    facing_->setToolTip(tr("Illuminance depends on which way the measuring surface looks"));
    for (const auto& facing : kFacings) facing_->addItem(tr(facing.name));
    connect(facing_, qOverload<int>(&QComboBox::activated), this, [this](int index) { change([=](ViewSettings& view) { view.sliceFacing = kFacings[index].normal; }); });
    level_ = new QDoubleSpinBox(group);
    level_->setObjectName(QStringLiteral("isosurfaceLevel"));
    level_->setRange(0.1, 1e6);
    level_->setKeyboardTracking(false);
    connect(level_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) { change([=, this](ViewSettings& view) { view.isosurfaceLux = session_.display().units.lux(value); }); });
    form->addRow(tr("On surfaces facing"), facing_);
    form->addRow(slice_, axis_);
    form->addRow(tr("At"), beside(offset_, offsetText_));
    form->addRow(addSwitch(tr("Iso-surface"), "isosurfaceOn", tr("Where the illuminance is just this"), &ViewSettings::isosurface), level_);
    return group;
}

QWidget* VolumeShow::sideBySide() {
    auto* group = new QGroupBox(tr("Side by side"), this);
    auto* layout = new QVBoxLayout(group);
    parts_ = new QPushButton(tr("Direct and indirect"), group);
    parts_->setObjectName(QStringLiteral("directIndirect"));
    parts_->setToolTip(tr("Two linked views: direct light on the left, indirect on the right"));
    connect(parts_, &QPushButton::clicked, this, &VolumeShow::directAgainstIndirect);
    volumes_ = new QPushButton(tr("Two volumes"), group);
    volumes_->setObjectName(QStringLiteral("twoVolumes"));
    volumes_->setToolTip(tr("Two linked views, each with a volume of its own: two algorithms, or before and after. Build or open a second volume first"));
    connect(volumes_, &QPushButton::clicked, this, &VolumeShow::twoVolumes);
    layout->addWidget(parts_);
    layout->addWidget(volumes_);
    return group;
}

void VolumeShow::setView(std::size_t index) {
    view_ = index;
    refresh();
}

void VolumeShow::change(const std::function<void(ViewSettings&)>& edit) {
    if (following_ || view_ >= session_.views().size()) return;
    auto settings = session_.views()[view_];
    edit(settings);
    session_.setView(view_, settings);
}

/// A horizontal slice that was never moved begins at the height of a desk.
void VolumeShow::switchSlice(bool on) {
    change([&](ViewSettings& view) {
        view.slice.on = on;
        const auto bounds = boundsOf(session_);
        if (!on || bounds.isEmpty() || view.slice != CutPlane{true}) return;
        // Floors are at the height 0 of most projects, whatever lies below them.
        const double desk = kWorkingPlaneM - session_.project()->project.scene.origin.z;
        view.slice.offsetM = (desk > bounds.min.z && desk < bounds.max.z ? desk : bounds.min.z + kWorkingPlaneM) - bounds.center().z;
    });
}

namespace {
/// Two linked views that show what the first shows.
void twoViews(Session& session, const ViewSettings& left, const ViewSettings& right) {
    session.setViewCount(2);
    auto display = session.display();
    display.linkedCameras = true;
    session.setDisplay(display);
    session.setView(0, left);
    session.setView(1, right);
}
}  // namespace

void VolumeShow::directAgainstIndirect() {
    auto left = session_.views()[view_];
    if (!left.slice.on && !left.isosurface) left.glyphs = true;
    auto right = left;
    left.part = LightPart::Direct, right.part = LightPart::Indirect;
    twoViews(session_, left, right);
}

void VolumeShow::twoVolumes() {
    const auto& all = session_.volumes.all();
    if (all.size() < 2) return;
    auto left = session_.views()[view_];
    if (!left.slice.on && !left.isosurface) left.glyphs = true;
    auto right = left;
    const std::size_t shown = session_.volumes.shownIndex();
    left.volume = all[shown].name;
    right.volume = all[shown == 0 ? 1 : shown - 1].name;
    twoViews(session_, left, right);
}

void VolumeShow::refreshNames(const ViewSettings& view) {
    const auto* shown = session_.volumes.shown();
    volume_->clear();
    volume_->addItem(shown != nullptr ? tr("The one chosen above (%1)").arg(qt(shown->name)) : tr("The one chosen above"), QString());
    for (const auto& state : session_.volumes.all()) volume_->addItem(qt(state.name), qt(state.name));
    volume_->setCurrentIndex(std::max(volume_->findData(qt(view.volume)), 0));
    volumes_->setEnabled(session_.volumes.all().size() > 1);
}

void VolumeShow::refresh() {
    if (view_ >= session_.views().size()) view_ = 0;
    const auto& view = session_.views()[view_];
    const auto& units = session_.display().units;
    following_ = true;
    title_->setVisible(session_.views().size() > 1);
    title_->setText(tr("View %1 of %2").arg(view_ + 1).arg(session_.views().size()));
    refreshNames(view);
    part_->setCurrentIndex(static_cast<int>(view.part));
    for (const auto& [box, member] : switches_) box->setChecked(view.*member);
    order_->setValue(view.order);
    orderText_->setText(view.order == 0 ? tr("radiance") : view.order == 1 ? tr("irradiance") : tr("moment %1").arg(view.order));
    radius_->setValue(static_cast<int>(std::lround(view.glyphRadiusM / kRadiusStepM)));
    radiusText_->setText(qt(units.lengthText(view.glyphRadiusM)));
    slice_->setChecked(view.slice.on);
    axis_->setCurrentIndex(indexOf(kSlices, view.slice.normal));
    facing_->setCurrentIndex(indexOf(kFacings, view.sliceFacing));
    const auto bounds = boundsOf(session_);
    offset_->setValue(static_cast<int>(std::lround(view.slice.offsetM / sectionReachM(bounds, view.slice.normal) * kOffsetSteps / 2)));
    // In the coordinates of the project.
    const double origin = session_.project() ? session_.project()->project.scene.origin.dot(view.slice.normal) : 0;
    offsetText_->setText(qt(units.lengthText(sectionPoint(view.slice, bounds).dot(view.slice.normal) + origin)));
    level_->setSuffix(QStringLiteral(" ") + QString::fromUtf8(units.illuminanceUnit()));
    level_->setDecimals(units.light == LightUnit::Lux ? 0 : 1);
    level_->setValue(units.illuminance(view.isosurfaceLux));
    for (QWidget* widget : std::initializer_list<QWidget*>{order_, orderText_, radius_, radiusText_}) widget->setEnabled(view.glyphs);
    for (QWidget* widget : std::initializer_list<QWidget*>{axis_, offset_, offsetText_}) widget->setEnabled(view.slice.on);
    level_->setEnabled(view.isosurface);
    following_ = false;
}

}  // namespace luxdeck::gui
