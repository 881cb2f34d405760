#include "gui/panels/picture_panel.h"

#include "gui/panels/look_controls.h"
#include "gui/panels/picture_view.h"
#include "gui/panels/qimage_of.h"
#include "gui/panels/text.h"

#include <QComboBox>
#include <QFileDialog>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace luxdeck::gui {

namespace {

constexpr int kControlsWidth = 336;

QWidget* emptyStage(QPushButton* button) {
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    auto* words = new QLabel(QObject::tr("No picture yet. Render a view: a first one is there within a second, and it gets better while you watch."));
    words->setObjectName(QStringLiteral("pictureEmpty"));
    words->setAlignment(Qt::AlignCenter);
    words->setWordWrap(true);
    words->setForegroundRole(QPalette::PlaceholderText);
    layout->addStretch(1);
    layout->addWidget(words);
    layout->addSpacing(8);
    layout->addWidget(button, 0, Qt::AlignCenter);
    layout->addStretch(1);
    return page;
}

QGroupBox* group(const QString& title, QWidget* inside) {
    auto* box = new QGroupBox(title);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 6, 0, 0);
    layout->addWidget(inside);
    return box;
}

QToolButton* tool(const QString& text, const char* name, const QString& tip) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setObjectName(QString::fromLatin1(name));
    button->setToolTip(tip);
    button->setCheckable(true);
    return button;
}

}  // namespace

PicturePanel::PicturePanel(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), stage_(new QStackedWidget(this)), view_(new PictureView), picture_(new QComboBox(this)), other_(new QComboBox(this)),
      fit_(tool(tr("Fit"), "pictureFit", tr("The whole picture"))), oneToOne_(tool(tr("1:1"), "pictureOneToOne", tr("One dot of the screen for each pixel. Zoom with the wheel, drag to move"))),
      save_(new QPushButton(tr("Save…"), this)), about_(new QLabel(this)), under_(new QLabel(this)), render_(new RenderControls(session)), look_(new LookControls(session)) {
    picture_->setObjectName(QStringLiteral("pictureChoice"));
    picture_->setAccessibleName(tr("Picture"));
    other_->setObjectName(QStringLiteral("pictureOther"));
    other_->setAccessibleName(tr("Picture to compare with"));
    other_->setToolTip(tr("A second picture, right of a divider that is dragged: another algorithm, or this view before the last changes"));
    save_->setObjectName(QStringLiteral("pictureSave"));
    save_->setToolTip(tr(".exr and .hdr hold the luminance in cd/m², .png what is seen here"));
    under_->setObjectName(QStringLiteral("pictureUnder"));
    about_->setObjectName(QStringLiteral("pictureAbout"));
    about_->setForegroundRole(QPalette::PlaceholderText);
    view_->setObjectName(QStringLiteral("pictureView"));
    auto* first = new QPushButton(tr("Render the first view"));
    first->setObjectName(QStringLiteral("pictureFirst"));
    stage_->addWidget(emptyStage(first));
    stage_->addWidget(view_);

    auto* bar = new QHBoxLayout;
    bar->addWidget(picture_, 2);
    bar->addWidget(new QLabel(tr("beside"), this));
    bar->addWidget(other_, 2);
    bar->addStretch(1);
    for (auto* button : {fit_, oneToOne_}) bar->addWidget(button);
    bar->addWidget(save_);
    auto* words = new QHBoxLayout;
    words->addWidget(under_, 1);
    words->addWidget(about_);
    auto* left = new QVBoxLayout;
    left->addLayout(bar);
    left->addWidget(stage_, 1);
    left->addLayout(words);

    auto* controls = new QWidget;
    auto* column = new QVBoxLayout(controls);
    column->setContentsMargins(10, 0, 10, 8);
    column->addWidget(group(tr("Render"), render_));
    column->addWidget(group(tr("Show"), look_));
    column->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(controls);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFixedWidth(kControlsWidth);
    auto* layout = new QHBoxLayout(this);
    layout->addLayout(left, 1);
    layout->addWidget(scroll);

    connect(first, &QPushButton::clicked, this, &PicturePanel::render);
    connect(fit_, &QToolButton::clicked, view_, &PictureView::fit);
    connect(oneToOne_, &QToolButton::clicked, view_, &PictureView::oneToOne);
    connect(view_, &PictureView::zoomChanged, this, [this] {
        fit_->setChecked(view_->fits());
        oneToOne_->setChecked(!view_->fits() && std::abs(view_->zoom() - 1) < 1e-6);
    });
    connect(view_, &PictureView::hovered, this, &PicturePanel::readUnder);
    connect(view_, &PictureView::left, this, [this] { under_->clear(), look_->mark(0); });
    connect(save_, &QPushButton::clicked, this, &PicturePanel::saveAs);
    connect(render_, &RenderControls::failed, this, &PicturePanel::failed);
    connect(picture_, QOverload<int>::of(&QComboBox::activated), this, [this] { session_.pictures.show(0, picture_->currentData().toULongLong()); });
    connect(other_, QOverload<int>::of(&QComboBox::activated), this, [this] { session_.pictures.show(1, other_->currentData().toULongLong()); });
    session_.observe([this](Change change) {
        if (change == Change::Pictures || change == Change::Project || change == Change::Display) refresh();
    });
    refresh();
}

void PicturePanel::setCamera(RenderControls::Camera camera) { render_->setCamera(std::move(camera)); }

void PicturePanel::render() { render_->start(); }

void PicturePanel::fillChoice(QComboBox* choice, std::size_t side) {
    const QSignalBlocker quiet(choice);
    choice->clear();
    if (side == 1) choice->addItem(tr("nothing"), 0);
    for (const auto& picture : session_.pictures.all()) choice->addItem(qt(picture.name()), static_cast<qulonglong>(picture.number));
    const auto* shown = session_.pictures.shown(side);
    choice->setCurrentIndex(std::max(side == 1 ? 0 : -1, shown != nullptr ? choice->findData(static_cast<qulonglong>(shown->number)) : -1));
    choice->setEnabled(choice->count() > (side == 1 ? 2 : 0));
}

void PicturePanel::showSide(std::size_t side) {
    const auto& developed = session_.pictures.developed(side);
    const auto* picture = session_.pictures.shown(side);
    const auto name = picture != nullptr ? qt(picture->name()) : QString();
    if (developed.get() == seen_[side] && name == names_[side]) return;
    view_->setPicture(static_cast<int>(side), developed && picture ? qimageOf(developed->image) : QImage(), name);
    seen_[side] = developed.get(), names_[side] = name;
}

void PicturePanel::refresh() {
    fillChoice(picture_, 0);
    fillChoice(other_, 1);
    const auto* shown = session_.pictures.shown(0);
    stage_->setCurrentIndex(shown != nullptr ? 1 : 0);
    if (auto* first = findChild<QPushButton*>(QStringLiteral("pictureFirst"))) first->setEnabled(session_.project() && !session_.project()->project.views.empty());
    if (shown != nullptr) view_->setNominalSize({shown->view.width, shown->view.height});
    showSide(0);
    showSide(1);
    for (auto* button : {fit_, oneToOne_}) button->setEnabled(shown != nullptr);
    save_->setEnabled(shown != nullptr && shown->image != nullptr);
    look_->refresh();
    describe();
}

void PicturePanel::describe() {
    const auto* shown = session_.pictures.shown(0);
    if (shown == nullptr || !shown->result) return about_->clear();
    const auto& r = *shown->result;
    auto text = tr("%1 × %2 px, %3 paths each, %4 s").arg(r.image.width()).arg(r.image.height()).arg(r.samplesPerPixel).arg(r.seconds, 0, 'f', 1);
    if (r.samplesPerPixel > 1) text += tr(", error ± %1 %").arg(qt(numberText(100 * r.relativeError)));
    if (!shown->running && (!r.complete || r.image.width() < shown->view.width)) text += tr(", stopped");
    about_->setText(text);
}

void PicturePanel::readUnder(int side, QPointF place) {
    const auto& image = session_.pictures.behind(static_cast<std::size_t>(side));
    if (!image || image->empty()) return under_->clear();
    const int x = std::clamp(static_cast<int>(place.x() * image->width()), 0, image->width() - 1), y = std::clamp(static_cast<int>(place.y() * image->height()), 0, image->height() - 1);
    const auto i = image->index(x, y);
    const Rgb c(image->channel("R")[i], image->channel("G")[i], image->channel("B")[i]);
    const double l = luminance(c, image->weights), error = image->has("stderr.Y") ? image->channel("stderr.Y")[i] : 0;
    const auto& units = session_.display().units;
    auto text = tr("%1 %2").arg(qt(error > 0 ? intervalText(units.luminance(l), units.luminance(1.96 * error)) : numberText(units.luminance(l))), qt(units.luminanceUnit()));
    text += tr("   RGB %1  %2  %3").arg(qt(numberText(units.luminance(c.r))), qt(numberText(units.luminance(c.g))), qt(numberText(units.luminance(c.b))));
    if (image->has("Z") && std::isfinite(image->channel("Z")[i])) text += tr("   %1 away").arg(qt(units.lengthText(image->channel("Z")[i])));
    under_->setText(text);
    look_->mark(l);
}

void PicturePanel::saveAs() {
    const auto* shown = session_.pictures.shown(0);
    if (shown == nullptr) return;
    const auto file = QFileDialog::getSaveFileName(this, tr("Save picture"), qt(shown->view.name) + QStringLiteral(".png"),
                                                   tr("As seen here (*.png);;Luminance, OpenEXR (*.exr);;Luminance, Radiance (*.hdr)"));
    if (file.isEmpty()) return;
    if (const auto begun = session_.pictures.save(shown->number, file.toStdString()); !begun) emit failed(qt(begun.error().text()));
}

}  // namespace luxdeck::gui
