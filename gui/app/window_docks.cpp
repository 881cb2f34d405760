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

QWidget* scrolled(QWidget* content) {
    auto* area = new QScrollArea;
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return area;
}

}  // namespace

QDockWidget* MainWindow::dock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(content);
    addDockWidget(area, dock);
    docks_.push_back(dock);
    return dock;
}

void MainWindow::makeDocks() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    auto* tree = new ProjectTree(session_);
    results_ = new ResultsPanel(session_);
    show_ = new ShowPanel(session_);
    solve_ = new SolvePanel(session_);
    dock(QStringLiteral("projectDock"), tr("Project"), tree, Qt::LeftDockWidgetArea);
    auto* solve = dock(QStringLiteral("solveDock"), tr("Calculate"), scrolled(solve_), Qt::RightDockWidgetArea);
    auto* show = dock(QStringLiteral("showDock"), tr("Show"), scrolled(show_), Qt::RightDockWidgetArea);
    tabifyDockWidget(solve, show);
    solve->raise();
    auto* results = dock(QStringLiteral("resultsDock"), tr("Results"), results_, Qt::BottomDockWidgetArea);
    auto* log = dock(QStringLiteral("logDock"), tr("Log"), new LogPanel(session_), Qt::BottomDockWidgetArea);
    tabifyDockWidget(results, log);
    results->raise();
}

void MainWindow::leaveOutWhatIsNotThere() {
    const bool open = session_.project() != nullptr;
    for (auto* dock : docks_) {
        dock->toggleViewAction()->setVisible(open);
        if (!open && !dock->isHidden()) {
            dock->setProperty("wasThere", true);
            dock->hide();
        } else if (open && dock->property("wasThere").toBool()) {
            dock->setProperty("wasThere", false);
            dock->show();
        }
    }
}

}  // namespace luxdeck::gui
