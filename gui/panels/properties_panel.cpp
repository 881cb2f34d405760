#include "gui/panels/properties_panel.h"

#include "gui/panels/property_form.h"
#include "gui/panels/text.h"

#include <QApplication>
#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace luxdeck::gui {

PropertiesPanel::PropertiesPanel(Session& session, QWidget* parent) : QScrollArea(parent), session_(session), message_(new QLabel) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* content = new QWidget(this);
    layout_ = new QVBoxLayout(content);
    message_->setObjectName(QStringLiteral("propertyMessage"));
    message_->setWordWrap(true);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    message_->hide();
    layout_->addWidget(message_);
    layout_->addStretch(1);
    setWidget(content);
    session_.observe([this](Change change) {
        switch (change) {
            case Change::Selection: say({}); [[fallthrough]];
            case Change::Project:
            case Change::Document:  // an edit was refused: the fields say again what holds
            case Change::Solve:
            case Change::Volumes:
            case Change::Furniture:
            case Change::Display: return soon();
            case Change::Log: {
                const auto& log = session_.place.log();
                if (log.size() > logSeen_ && log.back().severity == Severity::Error) say(qt(log.back().text));
                logSeen_ = log.size();
                return;
            }
            default: return;
        }
    });
    logSeen_ = session_.place.log().size();
    rebuild();
}

/// When control returns, once for all that has changed: not while one of the fields speaks.
void PropertiesPanel::soon() {
    if (waiting_) return;
    waiting_ = true;
    QTimer::singleShot(0, this, [this] {
        waiting_ = false;
        if (session_.place.jobs.running(JobKind::Load)) return;  // its project comes, and then this again
        rebuild();
    });
}

void PropertiesPanel::rebuild() {
    // Who was typing goes on in the same field.
    const auto* focused = QApplication::focusWidget();
    const bool mine = focused != nullptr && shown_ != nullptr && shown_->isAncestorOf(focused);
    const QString name = mine ? focused->objectName() : QString();
    auto* form = chosenForm();
    if (shown_ != nullptr) {
        shown_->blockSignals(true);
        layout_->removeWidget(shown_);
        shown_->hide();
        shown_->deleteLater();
    }
    shown_ = form;
    // With their paddings before anything is measured.
    for (auto* field : form->findChildren<QWidget*>()) field->ensurePolished();
    layout_->insertWidget(1, form);
    QTimer::singleShot(0, this, [this] { giveRoom(); });
    if (auto* again = name.isEmpty() ? nullptr : form->findChild<QWidget*>(name)) again->setFocus();
}

/// Fields scroll rather than being squashed.
void PropertiesPanel::giveRoom() {
    shown_->layout()->invalidate();
    layout_->invalidate();
    const int width = viewport()->width();
    widget()->setMinimumHeight(std::max(layout_->totalMinimumSize().height(), layout_->hasHeightForWidth() ? layout_->totalHeightForWidth(width) : 0));
}

void PropertiesPanel::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    if (shown_ != nullptr) giveRoom();
}

PropertyForm* PropertiesPanel::form(const QString& title, const QString& kind) {
    return new PropertyForm(title, kind, session_.display().units, widget());
}

PropertyForm* PropertiesPanel::chosenForm() {
    const auto shown = session_.project();
    if (!shown) return form(tr("Nothing is open"), tr("Open a project, and select something in the tree or a view to see and change it here."));
    const auto& project = shown->project;
    const auto [thing, index] = session_.selection();
    switch (thing) {
        case Thing::Luminaire: if (index < project.scene.luminaires.size()) return luminaireForm(project, index); break;
        case Thing::LuminaireType: if (index < project.scene.luminaireTypes.size()) return typeForm(project, index); break;
        case Thing::Grid: if (index < project.grids.size()) return gridForm(project, index); break;
        case Thing::View: if (index < project.views.size()) return viewForm(project, index); break;
        case Thing::Object: if (index < project.scene.objects.size()) return objectForm(project, index); break;
        case Thing::Material: if (index < project.scene.materials.size()) return materialForm(project, index); break;
        case Thing::Volume: if (index < session_.volumes.all().size()) return volumeForm(index); break;
        case Thing::Project:
        case Thing::None: break;
    }
    auto* whole = projectForm(project);
    if (thing == Thing::None) whole->note(tr("Select something in the tree or a view to see and change it here."));
    return whole;
}

void PropertiesPanel::change(const QString& what, const edits::Edit& edit) {
    say({});
    if (const auto done = session_.edit(what.toStdString(), edit); !done) {
        say(qt(done.error().text()));
        soon();
    }
}

void PropertiesPanel::say(const QString& message) {
    message_->setText(message.isEmpty() ? message : tr("Not changed: %1").arg(message));
    message_->setVisible(!message.isEmpty());
}

}  // namespace luxdeck::gui
