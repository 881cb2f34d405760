#include "gui/panels/show_panel.h"

#include "gui/panels/text.h"
#include "gui/session/scene_pick.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

/// What a section plane faces; what lies beyond it is cut away.
struct SectionAxis {
    const char* name;
    Vec3 normal;
};
const SectionAxis kSectionAxes[] = {{QT_TR_NOOP("from above"), {0, 0, 1}},     {QT_TR_NOOP("from the south"), {0, -1, 0}}, {QT_TR_NOOP("from the north"), {0, 1, 0}},
                                    {QT_TR_NOOP("from the west"), {-1, 0, 0}}, {QT_TR_NOOP("from the east"), {1, 0, 0}}};
constexpr int kOffsetSteps = 200;  // of the slider, over the scene's extent

/// Half of the scene's extent along a normal [m].
double reachOf(const Session& session, const Vec3d& normal) {
    return session.project() ? sectionReachM(session.project()->project.scene.bounds(), normal) : 1;
}

}  // namespace

ShowPanel::ShowPanel(Session& session, QWidget* parent) : QWidget(parent), session_(session), title_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    title_->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(title_);
    layout->addWidget(surfaces());
    layout->addWidget(light());
    layout->addWidget(section());
    layout->addWidget(legend());
    layout->addStretch(1);
    session_.observe([this](Change change) {
        if (change == Change::Display || change == Change::Project) refresh();
    });
    refresh();
}

QCheckBox* ShowPanel::addSwitch(const QString& text, const QString& tip, Switch member) {
    auto* box = new QCheckBox(text, this);
    box->setToolTip(tip);
    box->setObjectName(QStringLiteral("show") + QString(text).remove(QLatin1Char(' ')));
    connect(box, &QCheckBox::toggled, this, [this, member](bool on) { change([=](ViewSettings& view) { view.*member = on; }); });
    switches_.emplace_back(box, member);
    return box;
}

QWidget* ShowPanel::surfaces() {
    auto* group = new QGroupBox(tr("Room"), this);
    auto* layout = new QVBoxLayout(group);
    look_ = new QComboBox(group);
    look_->setObjectName(QStringLiteral("showSurfaces"));
    look_->addItems({tr("Materials"), tr("Plain"), tr("Wireframe"), tr("Hidden")});
    connect(look_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) { change([=](ViewSettings& view) { view.surfaces = static_cast<SurfaceLook>(index); }); });
    layout->addWidget(look_);
    layout->addWidget(addSwitch(tr("Hide ceiling from above"), tr("Ceilings are left out while they are looked at from above"), &ViewSettings::hideCeiling));
    layout->addWidget(addSwitch(tr("Luminaires"), tr("Bodies of the luminaires, with their marks"), &ViewSettings::luminaires));
    layout->addWidget(addSwitch(tr("Candela solids"), tr("Luminous intensity over direction, as a body at each luminaire"), &ViewSettings::candelaSolids));
    return group;
}

QWidget* ShowPanel::light() {
    auto* group = new QGroupBox(tr("Illuminance"), this);
    auto* layout = new QVBoxLayout(group);
    layout->addWidget(addSwitch(tr("Calculation surfaces"), tr("In false colour by the legend"), &ViewSettings::grids));
    layout->addWidget(addSwitch(tr("Isolines"), tr("Lines of equal illuminance"), &ViewSettings::isolines));
    layout->addWidget(addSwitch(tr("Values"), tr("A number at each point"), &ViewSettings::values));
    layout->addWidget(addSwitch(tr("Intervals"), tr("The 95 % interval beside each number"), &ViewSettings::intervals));
    layout->addWidget(addSwitch(tr("Verdicts"), tr("Ēm of each surface, and whether it meets what is required"), &ViewSettings::verdicts));
    auto* row = new QFormLayout;
    part_ = new QComboBox(group);
    part_->setObjectName(QStringLiteral("showPart"));
    part_->addItems({tr("Total"), tr("Direct"), tr("Indirect")});
    connect(part_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) { change([=](ViewSettings& view) { view.part = static_cast<LightPart>(index); }); });
    row->addRow(tr("Part"), part_);
    layout->addLayout(row);
    return group;
}

QWidget* ShowPanel::section() {
    auto* group = new QGroupBox(tr("Section"), this);
    auto* layout = new QVBoxLayout(group);
    sectionOn_ = new QCheckBox(tr("Cut the room open"), group);
    sectionOn_->setObjectName(QStringLiteral("sectionOn"));
    sectionAxis_ = new QComboBox(group);
    for (const auto& axis : kSectionAxes) sectionAxis_->addItem(tr(axis.name));
    sectionOffset_ = new QSlider(Qt::Horizontal, group);
    sectionOffset_->setObjectName(QStringLiteral("sectionOffset"));
    sectionOffset_->setRange(-kOffsetSteps / 2, kOffsetSteps / 2);
    sectionText_ = new QLabel(group);
    connect(sectionOn_, &QCheckBox::toggled, this, [this](bool on) { change([=](ViewSettings& view) { view.section.on = on; }); });
    connect(sectionAxis_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) { change([=](ViewSettings& view) { view.section.normal = kSectionAxes[index].normal; }); });
    connect(sectionOffset_, &QSlider::valueChanged, this, [this](int value) {
        change([=, this](ViewSettings& view) { view.section.offsetM = reachOf(session_, view.section.normal) * value * 2 / kOffsetSteps; });
    });
    layout->addWidget(sectionOn_);
    layout->addWidget(sectionAxis_);
    auto* row = new QHBoxLayout;
    row->addWidget(sectionOffset_, 1);
    row->addWidget(sectionText_);
    layout->addLayout(row);
    return group;
}

QWidget* ShowPanel::legend() {
    auto* group = new QGroupBox(tr("Legend of all views"), this);
    auto* form = new QFormLayout(group);
    automatic_ = new QCheckBox(tr("Automatic range"), group);
    automatic_->setObjectName(QStringLiteral("legendAutomatic"));
    logarithmic_ = new QCheckBox(tr("Logarithmic"), group);
    logarithmic_->setObjectName(QStringLiteral("legendLogarithmic"));
    low_ = new QDoubleSpinBox(group);
    high_ = new QDoubleSpinBox(group);
    low_->setObjectName(QStringLiteral("legendLow"));
    high_->setObjectName(QStringLiteral("legendHigh"));
    map_ = new QComboBox(group);
    map_->addItems({tr("Dusk: safe for colour-blind eyes"), tr("Heat")});
    for (auto* box : {low_, high_}) {
        box->setRange(0, 1e6);
        box->setDecimals(1);
        box->setKeyboardTracking(false);
    }
    connect(automatic_, &QCheckBox::toggled, this, [this](bool on) { changeLegend([=](LegendScale& scale) { scale.automatic = on; }); });
    connect(logarithmic_, &QCheckBox::toggled, this, [this](bool on) { changeLegend([=](LegendScale& scale) { scale.logarithmic = on; }); });
    connect(map_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int index) { changeLegend([=](LegendScale& scale) { scale.map = static_cast<tonemap::ColourMap>(index); }); });
    connect(low_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) { changeLegend([=, this](LegendScale& scale) { scale.low = session_.display().units.lux(value); }); });
    connect(high_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) { changeLegend([=, this](LegendScale& scale) { scale.high = session_.display().units.lux(value); }); });
    form->addRow(automatic_);
    form->addRow(logarithmic_);
    form->addRow(tr("From"), low_);
    form->addRow(tr("To"), high_);
    form->addRow(tr("Colours"), map_);
    return group;
}

void ShowPanel::setView(std::size_t index) {
    view_ = index;
    refresh();
}

void ShowPanel::change(const std::function<void(ViewSettings&)>& edit) {
    if (following_ || view_ >= session_.views().size()) return;
    auto settings = session_.views()[view_];
    edit(settings);
    session_.setView(view_, settings);
}

void ShowPanel::changeLegend(const std::function<void(LegendScale&)>& edit) {
    if (following_) return;
    auto display = session_.display();
    edit(display.legend);
    session_.setDisplay(display);
}

void ShowPanel::refresh() {
    if (view_ >= session_.views().size()) view_ = 0;
    const auto& view = session_.views()[view_];
    following_ = true;
    title_->setVisible(session_.views().size() > 1);
    title_->setText(tr("View %1 of %2").arg(view_ + 1).arg(session_.views().size()));
    for (const auto& [box, member] : switches_) box->setChecked(view.*member);
    look_->setCurrentIndex(static_cast<int>(view.surfaces));
    part_->setCurrentIndex(static_cast<int>(view.part));
    sectionOn_->setChecked(view.section.on);
    for (int i = 0; i < sectionAxis_->count(); ++i)
        if (kSectionAxes[i].normal == view.section.normal) sectionAxis_->setCurrentIndex(i);
    sectionOffset_->setValue(static_cast<int>(std::lround(view.section.offsetM / reachOf(session_, view.section.normal) * kOffsetSteps / 2)));
    for (QWidget* widget : std::initializer_list<QWidget*>{sectionAxis_, sectionOffset_, sectionText_}) widget->setEnabled(view.section.on);
    sectionText_->setText(qt(session_.display().units.lengthText(view.section.offsetM)));
    refreshLegend();
    following_ = false;
}

void ShowPanel::refreshLegend() {
    const auto& [legend, units, navigation, linked] = session_.display();
    automatic_->setChecked(legend.automatic);
    logarithmic_->setChecked(legend.logarithmic);
    map_->setCurrentIndex(static_cast<int>(legend.map));
    for (auto* box : {low_, high_}) {
        box->setEnabled(!legend.automatic);
        box->setSuffix(QStringLiteral(" ") + QString::fromUtf8(units.illuminanceUnit()));
    }
    low_->setValue(units.illuminance(legend.low));
    high_->setValue(units.illuminance(legend.high));
}

}  // namespace luxdeck::gui
