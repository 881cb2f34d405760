#include "gui/app/main_window.h"

#include "gui/panels/furniture_panel.h"
#include "gui/panels/lighting_panel.h"
#include "gui/panels/log_panel.h"
#include "gui/panels/project_tree.h"
#include "gui/panels/properties_panel.h"
#include "gui/panels/results_panel.h"
#include "gui/panels/show_panel.h"
#include "gui/panels/solve_panel.h"
#include "gui/panels/volume_panel.h"

#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>
#include <QStyle>

#include <algorithm>

/// The panels around the room, and which of them a project has a use for.
namespace luxdeck::gui {

namespace {

constexpr int kResultsHeight = 210, kSideWidth = 270, kLeastWidth = 266;

QWidget* scrolled(QWidget* content) {
    auto* area = new QScrollArea;
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    // Long entries must not make a panel wider than its dock.
    for (auto* choice : content->findChildren<QComboBox*>()) {
        choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        choice->setMinimumContentsLength(6);
    }
    area->setMinimumWidth(content->minimumSizeHint().width() + area->style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    return area;
}

}  // namespace

QDockWidget* MainWindow::dock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, room_);
    dock->setObjectName(name);
    dock->setWidget(content);
    room_->addDockWidget(area, dock);
    docks_.push_back(dock);
    return dock;
}

void MainWindow::makeDocks() {
    room_->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    room_->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    auto* tree = new ProjectTree(session_);
    results_ = new ResultsPanel(session_);
    show_ = new ShowPanel(session_);
    solve_ = new SolvePanel(session_);
    tree->setMinimumWidth(kLeastWidth);  // a change of theme lays docks out anew, as narrow as they may be
    auto* project = dock(QStringLiteral("projectDock"), tr("Project"), tree, Qt::LeftDockWidgetArea);
    auto* properties = dock(QStringLiteral("propertiesDock"), tr("Properties"), new PropertiesPanel(session_), Qt::LeftDockWidgetArea);
    auto* solve = dock(QStringLiteral("solveDock"), tr("Solve"), scrolled(solve_), Qt::RightDockWidgetArea);
    auto* show = dock(QStringLiteral("showDock"), tr("Show"), scrolled(show_), Qt::RightDockWidgetArea);
    lightingDock_ = dock(QStringLiteral("lightingDock"), tr("Lighting"), scrolled(new LightingPanel(session_)), Qt::RightDockWidgetArea);
    furniture_ = new FurniturePanel(session_);
    furnitureDock_ = dock(QStringLiteral("furnitureDock"), tr("Furniture"), scrolled(furniture_), Qt::RightDockWidgetArea);
    volume_ = new VolumePanel(session_);
    volumeDock_ = dock(QStringLiteral("volumeDock"), tr("Volume"), scrolled(volume_), Qt::RightDockWidgetArea);
    room_->tabifyDockWidget(solve, show);
    room_->tabifyDockWidget(show, lightingDock_);
    room_->tabifyDockWidget(lightingDock_, furnitureDock_);
    room_->tabifyDockWidget(furnitureDock_, volumeDock_);
    solve->raise();
    auto* results = dock(QStringLiteral("resultsDock"), tr("Results"), results_, Qt::BottomDockWidgetArea);
    auto* log = dock(QStringLiteral("logDock"), tr("Log"), new LogPanel(session_), Qt::BottomDockWidgetArea);
    room_->tabifyDockWidget(results, log);
    results->raise();
    room_->resizeDocks({results}, {kResultsHeight}, Qt::Vertical);
    room_->resizeDocks({project, properties}, {1, 1}, Qt::Vertical);
    room_->resizeDocks({project, solve}, {kSideWidth, kSideWidth + 60}, Qt::Horizontal);
}

/// What the project lacks has no panel: no volumes, no panel of volumes.
void MainWindow::leaveOutWhatIsNotThere() {
    const auto loaded = session_.project();
    leaveOut(lightingDock_, !loaded || loaded->project.scene.luminaires.empty());
    const auto movable = [](const SceneObject& object) { return object.movable; };
    leaveOut(furnitureDock_, !loaded || std::none_of(loaded->project.scene.objects.begin(), loaded->project.scene.objects.end(), movable));
}

void MainWindow::showDock(QDockWidget* dock) {
    dock->show();
    dock->raise();
}

void MainWindow::leaveOut(QDockWidget* dock, bool out) {
    dock->toggleViewAction()->setVisible(!out);
    const bool isOut = dock->property("leftOut").toBool();
    if (out && !isOut && !dock->isHidden()) {
        dock->setProperty("leftOut", true);
        dock->hide();
    } else if (!out && isOut) {
        dock->setProperty("leftOut", false);
        dock->show();
    }
}

}  // namespace luxdeck::gui
