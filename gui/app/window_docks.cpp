#include "gui/app/main_window.h"

#include "gui/panels/log_panel.h"
#include "gui/panels/project_tree.h"
#include "gui/panels/results_panel.h"
#include "gui/panels/show_panel.h"
#include "gui/panels/solve_panel.h"

#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>

/// The panels around the room, and which of them a project has a use for.
namespace luxdeck::gui {

namespace {

constexpr int kResultsHeight = 230, kSideWidth = 270;

QWidget* scrolled(QWidget* content) {
    auto* area = new QScrollArea;
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
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
    room_->setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    room_->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    auto* tree = new ProjectTree(session_);
    results_ = new ResultsPanel(session_);
    show_ = new ShowPanel(session_);
    solve_ = new SolvePanel(session_);
    dock(QStringLiteral("projectDock"), tr("Project"), tree, Qt::LeftDockWidgetArea);
    auto* solve = dock(QStringLiteral("solveDock"), tr("Calculate"), scrolled(solve_), Qt::RightDockWidgetArea);
    auto* show = dock(QStringLiteral("showDock"), tr("Show"), scrolled(show_), Qt::RightDockWidgetArea);
    room_->tabifyDockWidget(solve, show);
    solve->raise();
    auto* results = dock(QStringLiteral("resultsDock"), tr("Results"), results_, Qt::BottomDockWidgetArea);
    auto* log = dock(QStringLiteral("logDock"), tr("Log"), new LogPanel(session_), Qt::BottomDockWidgetArea);
    room_->tabifyDockWidget(results, log);
    results->raise();
    room_->resizeDocks({results}, {kResultsHeight}, Qt::Vertical);
    room_->resizeDocks({docks_.front(), solve}, {kSideWidth, kSideWidth + 20}, Qt::Horizontal);
}

/// What the project lacks has no panel: no volumes, no panel of volumes.
void MainWindow::leaveOutWhatIsNotThere() {
}

}  // namespace luxdeck::gui
