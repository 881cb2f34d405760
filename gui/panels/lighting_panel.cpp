#include "gui/panels/lighting_panel.h"

#include "gui/panels/text.h"
#include "gui/session/edits.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <map>

namespace luxdeck::gui {

namespace {

QString percentText(double low, double high) {
    if (high - low < 0.005) return QObject::tr("%1 %").arg(std::lround(100 * high));
    return QObject::tr("%1 to %2 %").arg(std::lround(100 * low)).arg(std::lround(100 * high));
}

}  // namespace

LightingPanel::LightingPanel(Session& session, QWidget* parent) : QWidget(parent), session_(session), grid_(new QGridLayout), note_(new QLabel(this)) {
    setObjectName(QStringLiteral("lightingPanel"));
    grid_->setColumnStretch(1, 1);
    note_->setWordWrap(true);
    note_->setForegroundRole(QPalette::PlaceholderText);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(grid_);
    layout->addWidget(note_);
    layout->addStretch(1);
    session_.observe([this](Change change) {
        if (change == Change::Project) rebuild();
        if (change == Change::Project || change == Change::Solve) explain();
    });
    rebuild();
    explain();
}

void LightingPanel::rebuild() {
    std::vector<std::string> types;
    if (session_.project())
        for (const auto& type : session_.project()->project.scene.luminaireTypes) types.push_back(type.id);
    if (types == types_) return showDimmings();
    types_ = types;
    rows_.clear();
    while (auto* item = grid_->takeAt(0)) {
        if (item->widget() != nullptr) item->widget()->deleteLater();
        delete item;
    }
    for (std::size_t i = 0; i < types_.size(); ++i) {
        const auto& type = session_.project()->project.scene.luminaireTypes[i];
        Row row{new QCheckBox(this), new QSlider(Qt::Horizontal, this), new QLabel(this)};
        row.on->setText(type.description.empty() ? qt(type.id) : qt(type.id + "  " + type.description));
        row.on->setToolTip(tr("Switches all luminaires of this type"));
        row.on->setObjectName(QStringLiteral("switch") + qt(type.id));
        row.dimmer->setRange(0, 100);
        row.dimmer->setObjectName(QStringLiteral("dimmer") + qt(type.id));
        row.dimmer->setAccessibleName(tr("Dimming of %1").arg(qt(type.id)));
        row.percent->setMinimumWidth(fontMetrics().horizontalAdvance(tr("%1 to %2 %").arg(100).arg(100)));
        row.percent->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        const int line = static_cast<int>(2 * i);
        grid_->addWidget(row.on, line, 0, 1, 3);
        grid_->addWidget(row.dimmer, line + 1, 0, 1, 2);
        grid_->addWidget(row.percent, line + 1, 2);
        connect(row.on, &QCheckBox::clicked, this, [this, i](bool on) { commit(i, on ? 1 : 0); });
        connect(row.dimmer, &QSlider::valueChanged, this, [this, i](int value) {
            if (!following_) preview(i, value / 100.0);
        });
        connect(row.dimmer, &QSlider::sliderReleased, this, [this, i, dimmer = row.dimmer] { commit(i, dimmer->value() / 100.0); });
        rows_.push_back(row);
    }
    showDimmings();
}

void LightingPanel::showDimmings() {
    if (!session_.project()) return;
    const auto& scene = session_.project()->project.scene;
    following_ = true;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        double low = 1, high = 0;
        for (const auto& luminaire : scene.luminaires)
            if (luminaire.type == i) low = std::min(low, luminaire.dimming), high = std::max(high, luminaire.dimming);
        low = std::min(low, high);
        rows_[i].on->setChecked(high > 0);
        rows_[i].on->setEnabled(session_.editable());
        rows_[i].dimmer->setEnabled(session_.editable());
        if (!rows_[i].dimmer->isSliderDown()) rows_[i].dimmer->setValue(static_cast<int>(std::lround(100 * high)));
        rows_[i].percent->setText(percentText(low, high));
    }
    following_ = false;
}

void LightingPanel::preview(std::size_t type, double dimming) {
    rows_[type].percent->setText(percentText(dimming, dimming));
    if (!rows_[type].dimmer->isSliderDown()) return commit(type, dimming);  // by keys or a click on its groove
    std::map<std::string, double> dimmings;
    for (const auto& luminaire : session_.project()->project.scene.luminaires) dimmings[luminaire.name] = luminaire.type == type ? dimming : luminaire.dimming;
    session_.solving.preview(dimmings);
}

void LightingPanel::commit(std::size_t type, double dimming) {
    const auto project = session_.project();
    if (!project || type >= types_.size()) return;
    const auto luminaires = edits::luminairesOfType(project->project, type);
    const auto changed = std::any_of(luminaires.begin(), luminaires.end(), [&](std::size_t i) { return project->project.scene.luminaires[i].dimming != dimming; });
    if (!changed) return;
    const auto what = dimming > 0 ? "Dim " + types_[type] : "Switch off " + types_[type];
    if (const auto done = session_.edit(what, edits::changeLuminaires(project, luminaires, {.dimming = dimming})); !done) session_.place.complain(done.error());
}

void LightingPanel::explain() {
    if (!session_.solving.result()) note_->setText(tr("Solve with \"Keep the light of each luminaire apart\" and results follow dimmers at once."));
    else if (session_.solving.followsDimming()) note_->setText(tr("Results follow at once: the light of each luminaire is known apart."));
    else note_->setText(tr("Results are old after a change: solve again, or with \"Keep the light of each luminaire apart\" to let them follow."));
}

}  // namespace luxdeck::gui
