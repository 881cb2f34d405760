#include "gui/panels/furniture_panel.h"

#include "analysis/report/canvas.h"
#include "gui/panels/text.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>

namespace luxdeck::gui {

namespace {

constexpr double kExactTarget = 0.02;  // of the two solves behind the room's exact change

QDoubleSpinBox* number(const QString& name, double low, double high, int decimals, double step, QWidget* parent) {
    auto* box = new QDoubleSpinBox(parent);
    box->setObjectName(name);
    box->setRange(low, high);
    box->setDecimals(decimals);
    box->setSingleStep(step);
    box->setKeyboardTracking(false);
    return box;
}

QColor colourOf(FurnitureVerdict verdict, const QPalette& palette) {
    switch (verdict) {
        case FurnitureVerdict::Met: return report::ink::kMet;
        case FurnitureVerdict::Under:
        case FurnitureVerdict::Over: return report::ink::kNotMet;
        case FurnitureVerdict::Undecided: return report::ink::kUndecided;
        case FurnitureVerdict::None: return palette.color(QPalette::Mid);
    }
    return palette.color(QPalette::Mid);
}

void setCell(QTableWidget* table, int row, int column, const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table->setItem(row, column, item);
}

}  // namespace

FurniturePanel::FurniturePanel(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
    setObjectName(QStringLiteral("furniturePanel"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(chooser());
    layout->addWidget(hand());
    layout->addStretch(1);
    session_.observe([this](Change change) {
        if (change == Change::Project) fillObjects();
        if (change == Change::Furniture || change == Change::Project || change == Change::Jobs || change == Change::Display) refresh();
        if (change == Change::Selection && session_.selection().thing == Thing::Object && session_.project())
            object_->setCurrentText(qt(session_.project()->project.scene.objects[session_.selection().index].name));
    });
    fillObjects();
    refresh();
}

QWidget* FurniturePanel::chooser() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    object_ = new QComboBox(box);
    object_->setObjectName(QStringLiteral("furnitureObject"));
    begin_ = new QPushButton(tr("Move with light"), box);
    begin_->setObjectName(QStringLiteral("furnitureBegin"));
    begin_->setToolTip(tr("Computes the light of the room without it, once; then its illuminance follows each move"));
    state_ = new QLabel(box);
    state_->setWordWrap(true);
    state_->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(object_);
    layout->addWidget(begin_);
    layout->addWidget(state_);
    connect(begin_, &QPushButton::clicked, this, [this] { session_.furnishing.begin(object_->currentText().toStdString()); });
    return box;
}

QWidget* FurniturePanel::hand() {
    hand_ = new QWidget(this);
    auto* layout = new QVBoxLayout(hand_);
    layout->setContentsMargins(0, 8, 0, 0);
    verdict_ = new QLabel(hand_);
    verdict_->setObjectName(QStringLiteral("furnitureVerdict"));
    verdict_->setWordWrap(true);
    layout->addWidget(verdict_);
    auto* form = new QFormLayout;
    x_ = number(QStringLiteral("furnitureX"), -1e6, 1e6, 2, 0.1, hand_);
    y_ = number(QStringLiteral("furnitureY"), -1e6, 1e6, 2, 0.1, hand_);
    turn_ = number(QStringLiteral("furnitureTurn"), -360, 360, 1, 15, hand_);
    required_ = number(QStringLiteral("furnitureRequired"), 0, 1e6, 0, 50, hand_);
    limit_ = number(QStringLiteral("furnitureLimit"), 0, 1e6, 0, 50, hand_);
    turn_->setSuffix(QStringLiteral("°"));
    for (auto* box : {required_, limit_}) box->setSpecialValueText(tr("none"));
    form->addRow(tr("x"), x_);
    form->addRow(tr("y"), y_);
    form->addRow(tr("Turned by"), turn_);
    form->addRow(tr("Ēm required"), required_);
    form->addRow(tr("Nowhere above"), limit_);
    from_ = new QLabel(hand_);
    from_->setWordWrap(true);
    from_->setForegroundRole(QPalette::PlaceholderText);
    form->addRow(from_);
    layout->addLayout(form);
    auto* buttons = new QHBoxLayout;
    leave_ = new QPushButton(tr("Leave it here"), hand_);
    leave_->setObjectName(QStringLiteral("furnitureLeave"));
    leave_->setToolTip(tr("Writes the new place into the project; can be undone"));
    back_ = new QPushButton(tr("Put it back"), hand_);
    back_->setObjectName(QStringLiteral("furnitureBack"));
    buttons->addWidget(leave_, 1);
    buttons->addWidget(back_);
    layout->addLayout(buttons);

    estimate_ = new QPushButton(tr("What it takes from the room"), hand_);
    estimate_->setObjectName(QStringLiteral("furnitureEstimate"));
    estimate_->setToolTip(tr("Estimate to first order: what it hides from each calculation surface, and gives back"));
    solve_ = new QPushButton(tr("Solve it exactly"), hand_);
    solve_->setToolTip(tr("Solves the room without it and with it"));
    auto* room = new QVBoxLayout;
    room->addWidget(estimate_);
    room->addWidget(solve_);
    layout->addSpacing(8);
    layout->addLayout(room);
    roomState_ = new QLabel(hand_);
    roomState_->setWordWrap(true);
    roomState_->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(roomState_);
    room_ = new QTableWidget(hand_);
    room_->setObjectName(QStringLiteral("furnitureRoom"));
    room_->setColumnCount(3);
    room_->verticalHeader()->setVisible(false);
    room_->setShowGrid(false);
    room_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    room_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    room_->setMinimumHeight(180);
    layout->addWidget(room_);

    for (auto* box : {x_, y_, turn_}) connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &FurniturePanel::moveByNumbers);
    for (auto* box : {required_, limit_}) connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &FurniturePanel::require);
    connect(leave_, &QPushButton::clicked, this, [this] {
        if (const auto left = session_.furnishing.commit(session_); !left) session_.place.complain(left.error());
    });
    connect(back_, &QPushButton::clicked, this, [this] { session_.furnishing.cancel(); });
    connect(estimate_, &QPushButton::clicked, this, [this] { session_.furnishing.estimateRoom(); });
    connect(solve_, &QPushButton::clicked, this, [this] {
        SolveSettings settings;
        settings.algorithm = "shared";
        settings.targetError = kExactTarget;
        session_.furnishing.solveRoom(settings);
    });
    return hand_;
}

void FurniturePanel::begin() {
    const auto& selection = session_.selection();
    if (selection.thing == Thing::Object && session_.project()) object_->setCurrentText(qt(session_.project()->project.scene.objects[selection.index].name));
    begin_->click();
}

void FurniturePanel::fillObjects() {
    const auto before = object_->currentText();
    object_->clear();
    if (session_.project())
        for (const auto& object : session_.project()->project.scene.objects)
            if (object.movable) object_->addItem(qt(object.name));
    object_->setCurrentText(before);
}

void FurniturePanel::refresh() {
    const auto& furnishing = session_.furnishing;
    const bool preparing = furnishing.state() == Furnishing::State::Preparing, ready = furnishing.state() == Furnishing::State::Ready;
    begin_->setEnabled(object_->count() > 0 && !preparing);
    hand_->setVisible(ready);
    if (object_->count() == 0) state_->setText(tr("Nothing here may be moved: select an object and allow it in its properties."));
    else if (preparing) state_->setText(tr("Lighting the room without %1 …").arg(qt(furnishing.object())));
    else if (ready) state_->setText(tr("%1 is in hand: drag its handles in the view, or type where it goes.").arg(qt(furnishing.object())));
    else state_->setText(tr("Choose what to move; its illuminance then follows your hand."));
    if (furnishing.object() != inHand_) {
        inHand_ = furnishing.object();
        if (!inHand_.empty()) object_->setCurrentText(qt(inHand_));  // also when it was taken elsewhere
    }
    if (ready) refreshHand();
}

void FurniturePanel::refreshHand() {
    const auto& furnishing = session_.furnishing;
    const auto& units = session_.display().units;
    following_ = true;
    verdict_->setText(qt(furnishing.statement(units)));
    const auto colour = colourOf(furnishing.light().verdict, palette());
    verdict_->setStyleSheet(QStringLiteral("border: none; border-left: 4px solid %1; background: rgba(%2, %3, %4, 40); padding: 6px 8px; font-weight: 600;")
                                .arg(colour.name())
                                .arg(colour.red())
                                .arg(colour.green())
                                .arg(colour.blue()));
    const auto place = furnishing.pivot() + Vec3d(furnishing.pose().moveM);
    x_->setSuffix(QStringLiteral(" ") + QString::fromUtf8(units.lengthUnit()));
    y_->setSuffix(x_->suffix());
    if (!x_->hasFocus()) x_->setValue(units.lengthOf(place.x));
    if (!y_->hasFocus()) y_->setValue(units.lengthOf(place.y));
    if (!turn_->hasFocus()) turn_->setValue(furnishing.pose().turnDeg);
    const auto& requirement = furnishing.requirement();
    for (auto* box : {required_, limit_}) box->setSuffix(QStringLiteral(" ") + QString::fromUtf8(units.illuminanceUnit()));
    if (!required_->hasFocus()) required_->setValue(units.illuminance(requirement.meanAtLeast.value_or(0)));
    if (!limit_->hasFocus()) limit_->setValue(units.illuminance(requirement.limit.value_or(0)));
    from_->setVisible(!furnishing.requiredBy().empty());
    from_->setText(tr("Required by the calculation surface \"%1\".").arg(qt(furnishing.requiredBy())));
    leave_->setEnabled(session_.editable());
    refreshRoom();
    following_ = false;
}

void FurniturePanel::refreshRoom() {
    const auto& change = session_.furnishing.roomChange();
    const auto& units = session_.display().units;
    const bool any = change.has_value() && (!change->estimated.empty() || change->exact);
    room_->setVisible(any);
    roomState_->setVisible(any);
    if (!any) return;
    roomState_->setText(session_.furnishing.roomChangeCurrent() ? (change->exact ? tr("Solved without and with it.") : tr("Estimated to first order, without an interval."))
                                                                : tr("Of where it was before: ask again."));
    const auto unit = QString::fromUtf8(units.illuminanceUnit());
    room_->setHorizontalHeaderLabels({tr("Calculation surface"), tr("without [%1]").arg(unit), tr("taken [%1]").arg(unit)});
    const auto rows = change->exact ? change->exact->grids.size() : change->estimated.size();
    room_->setRowCount(static_cast<int>(rows));
    for (std::size_t i = 0; i < rows; ++i) {
        const int row = static_cast<int>(i);
        if (change->exact) {
            const auto& grid = change->exact->grids[i];
            setCell(room_, row, 0, qt(grid.name));
            setCell(room_, row, 1, qt(intervalText(units.illuminance(grid.emptyMean.interval.value), units.illuminance(grid.emptyMean.interval.ci95))));
            setCell(room_, row, 2, qt(intervalText(units.illuminance(grid.takenMean.value), units.illuminance(grid.takenMean.ci95))));
        } else {
            const auto& grid = change->estimated[i];
            setCell(room_, row, 0, qt(grid.name));
            setCell(room_, row, 1, qt(numberText(units.illuminance(grid.mean.empty))));
            setCell(room_, row, 2, qt(numberText(units.illuminance(grid.mean.taken()))));
        }
    }
}

void FurniturePanel::moveByNumbers() {
    if (following_) return;
    auto& furnishing = session_.furnishing;
    const auto& units = session_.display().units;
    const auto pivot = furnishing.pivot();
    Pose pose = furnishing.pose();
    pose.moveM.x = static_cast<float>(units.metres(x_->value()) - pivot.x);
    pose.moveM.y = static_cast<float>(units.metres(y_->value()) - pivot.y);
    pose.turnDeg = turn_->value();
    furnishing.moveTo(pose);
}

void FurniturePanel::require() {
    if (following_) return;
    const auto& units = session_.display().units;
    LightRequirement requirement;
    if (required_->value() > 0) requirement.meanAtLeast = units.lux(required_->value());
    if (limit_->value() > 0) requirement.limit = units.lux(limit_->value());
    session_.furnishing.setRequirement(requirement);
}

}  // namespace luxdeck::gui
