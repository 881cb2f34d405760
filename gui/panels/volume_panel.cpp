#include "gui/panels/volume_panel.h"

#include "gui/panels/text.h"
#include "gui/panels/volume_form.h"
#include "gui/panels/volume_show.h"

#include <QFileDialog>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QPushButton>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

enum Column { kName, kVertices, kError, kTime };

QString errorText(const IrradianceVolume& volume) {
    const double error = 1.96 * volume.relativeError() * 100;
    return std::isfinite(error) ? QStringLiteral("± %1 %").arg(error, 0, 'f', error < 10 ? 1 : 0) : QStringLiteral("± ?");
}

/// All that is known of a volume, a line each.
QString explain(const VolumeState& state) {
    const auto& v = *state.volume;
    const QLocale locale;
    QStringList lines{
        VolumePanel::tr("%1 vertices, %2 of them inside solids; %3 directions each").arg(locale.toString(static_cast<qulonglong>(v.vertexCount())), locale.toString(static_cast<qulonglong>(v.unusable()))).arg(v.binCount()),
        VolumePanel::tr("Algorithm %1, %2 rays in %3 s; %4 in memory").arg(qt(v.algorithm), locale.toString(static_cast<qulonglong>(v.rays))).arg(v.seconds, 0, 'f', 1).arg(locale.formattedDataSize(static_cast<qint64>(v.bytes()), 0))};
    if (v.interpolationError >= 0) lines << VolumePanel::tr("Interpolation between vertices: %1 % rms").arg(100 * v.interpolationError, 0, 'g', 2);
    if (!state.file.empty()) lines << qt(state.file.string());
    if (!state.without.empty()) lines << VolumePanel::tr("Of the room without %1").arg(qt(state.without));
    if (!v.complete) lines << VolumePanel::tr("Incomplete: it was stopped");
    if (!state.current) lines << VolumePanel::tr("Old: the project has changed since. Build it again to be up to date");
    return lines.join(QLatin1Char('\n'));
}

}  // namespace

VolumePanel::VolumePanel(Session& session, QWidget* parent) : QWidget(parent), session_(session), form_(new VolumeForm(session, this)), show_(new VolumeShow(session, this)) {
    auto* layout = new QVBoxLayout(this);
    auto* build = new QGroupBox(tr("Build"), this);
    auto* inside = new QVBoxLayout(build);
    inside->addWidget(form_);
    layout->addWidget(volumes());
    layout->addWidget(show_);
    layout->addWidget(build);
    layout->addStretch(1);
    session_.observe([panel = QPointer<VolumePanel>(this)](Change change) {
        if (panel && (change == Change::Volumes || change == Change::Project)) panel->refresh();
    });
    refresh();
}

QWidget* VolumePanel::volumes() {
    auto* group = new QGroupBox(tr("Irradiance volumes"), this);
    auto* layout = new QVBoxLayout(group);
    empty_ = new QLabel(tr("A volume holds the light at every place and in every direction of the room: build one below, or open one."), group);
    empty_->setObjectName(QStringLiteral("volumeEmpty"));
    empty_->setWordWrap(true);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    list_ = new QTreeWidget(group);
    list_->setObjectName(QStringLiteral("volumeList"));
    list_->setAccessibleName(tr("Irradiance volumes"));
    list_->setHeaderLabels({tr("Name"), tr("Vertices"), tr("Error"), tr("Built in")});
    list_->setRootIsDecorated(false);
    list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
    list_->header()->setStretchLastSection(false);
    connect(list_, &QTreeWidget::itemSelectionChanged, this, [this] {
        if (!following_ && chosen() >= 0) session_.volumes.show(static_cast<std::size_t>(chosen()));
    });
    auto* open = new QPushButton(tr("Open…"), group);
    open->setObjectName(QStringLiteral("volumeOpen"));
    save_ = new QPushButton(tr("Save…"), group);
    save_->setObjectName(QStringLiteral("volumeSave"));
    remove_ = new QPushButton(tr("Remove"), group);
    remove_->setObjectName(QStringLiteral("volumeRemove"));
    connect(open, &QPushButton::clicked, this, &VolumePanel::openFile);
    connect(save_, &QPushButton::clicked, this, &VolumePanel::saveFile);
    connect(remove_, &QPushButton::clicked, this, [this] {
        if (chosen() >= 0) session_.volumes.remove(static_cast<std::size_t>(chosen()));
    });
    auto* buttons = new QHBoxLayout;
    for (auto* button : {open, save_, remove_}) buttons->addWidget(button);
    layout->addWidget(empty_);
    layout->addWidget(list_);
    layout->addLayout(buttons);
    return group;
}

void VolumePanel::setView(std::size_t index) { show_->setView(index); }

void VolumePanel::build() { form_->start(); }

int VolumePanel::chosen() const { return list_->currentItem() != nullptr && list_->currentItem()->isSelected() ? list_->indexOfTopLevelItem(list_->currentItem()) : -1; }

void VolumePanel::openFile() {
    const auto file = QFileDialog::getOpenFileName(this, tr("Open volume"), {}, tr("Irradiance volumes (*.vtu)"));
    if (file.isEmpty()) return;
    if (const auto opened = session_.volumes.open(file.toStdString()); !opened) session_.place.complain(opened.error());
}

void VolumePanel::saveFile() {
    const int index = chosen();
    if (index < 0) return;
    const auto& state = session_.volumes.all()[static_cast<std::size_t>(index)];
    const auto suggested = state.file.empty() ? qt(state.name) + QStringLiteral(".vtu") : qt(state.file.string());
    const auto file = QFileDialog::getSaveFileName(this, tr("Save volume"), suggested, tr("Irradiance volumes (*.vtu)"));
    if (file.isEmpty()) return;
    if (const auto saved = session_.volumes.save(static_cast<std::size_t>(index), file.toStdString()); !saved) session_.place.complain(saved.error());
}

void VolumePanel::listVolumes() {
    following_ = true;
    list_->clear();
    const QLocale locale;
    for (const auto& state : session_.volumes.all()) {
        auto* item = new QTreeWidgetItem(list_, {qt(state.name), locale.toString(static_cast<qulonglong>(state.volume->vertexCount())), errorText(*state.volume),
                                                 QStringLiteral("%1 s").arg(state.volume->seconds, 0, 'f', 1)});
        for (const int column : {kVertices, kError, kTime}) item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        for (int column = kName; column <= kTime; ++column) item->setToolTip(column, explain(state));
        if (!state.current || !state.volume->complete) item->setIcon(kName, style()->standardIcon(QStyle::SP_MessageBoxWarning));
    }
    list_->setCurrentItem(list_->topLevelItem(static_cast<int>(session_.volumes.shownIndex())));
    // As high as its rows, up to six.
    const int rows = std::min(list_->topLevelItemCount(), 6);
    const int row = rows > 0 ? list_->visualItemRect(list_->topLevelItem(0)).height() : 0;
    list_->setFixedHeight(list_->header()->sizeHint().height() + rows * std::max(row, list_->fontMetrics().height() + 6) + 2 * list_->frameWidth() + 4);
    following_ = false;
}

void VolumePanel::refresh() {
    const bool any = !session_.volumes.all().empty();
    empty_->setVisible(!any);
    list_->setVisible(any);
    show_->setVisible(any);
    save_->setEnabled(any);
    remove_->setEnabled(any);
    listVolumes();
}

}  // namespace luxdeck::gui
