#include "gui/app/main_window.h"

#include "gui/app/shortcuts_dialog.h"
#include "gui/panels/picture_panel.h"
#include "gui/panels/results_panel.h"
#include "gui/panels/solve_panel.h"
#include "gui/panels/volume_panel.h"
#include "gui/view3d/view_area.h"

#include "engine/core/version.h"

#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QTabWidget>
#include <QToolBar>

/// Every command of the window, by menu.
namespace luxdeck::gui {

QAction* MainWindow::command(QMenu* menu, Needs needs, const CommandText& text, std::function<void()> run) {
    auto* action = menu->addAction(tr(text.text));
    action->setObjectName(QString::fromLatin1(text.name));
    action->setShortcut(QKeySequence(QString::fromLatin1(text.keys)));
    action->setStatusTip(tr(text.tip));
    action->setToolTip(tr(text.tip));
    action->setProperty("menu", menu->title().remove(QLatin1Char('&')));
    connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
    commands_.push_back(action);
    if (needs != Needs::Nothing) needProject_.push_back(action);
    if (needs == Needs::Editable) needEditable_.push_back(action);
    return action;
}

QAction* MainWindow::choice(QMenu* menu, QActionGroup* group, const CommandText& text, bool on, std::function<void()> run) {
    auto* action = command(menu, Needs::Nothing, text, std::move(run));
    action->setCheckable(true);
    action->setChecked(on);
    group->addAction(action);
    return action;
}

void MainWindow::makeMenus() {
    fileMenu();
    editMenu();
    insertMenu();
    viewMenu();
    calculateMenu();
    helpMenu();
    auto* quick = new QToolBar(workspaces_);
    quick->setToolButtonStyle(Qt::ToolButtonTextOnly);
    for (const char* name : {"undo", "redo", "fitView", "solve", "render"}) quick->addAction(findChild<QAction*>(QString::fromLatin1(name)));
    workspaces_->setCornerWidget(quick);
    refreshCommands();
}

void MainWindow::fileMenu() {
    auto* menu = menuBar()->addMenu(tr("&File"));
    command(menu, Needs::Nothing, {"newProject", "&New project from geometry…", "Ctrl+N", "A first project of a model: a workplane, a view, a volume"}, [this] { askForNew(); });
    command(menu, Needs::Nothing, {"openProject", "&Open…", "Ctrl+O", "A project.toml, or a model by itself"}, [this] { askToOpen(); });
    recentMenu_ = menu->addMenu(tr("Open &recent"));
    connect(recentMenu_, &QMenu::aboutToShow, this, &MainWindow::recentMenu);
    menu->addSeparator();
    save_ = command(menu, Needs::Editable, {"saveProject", "&Save", "Ctrl+S", "Writes the project file"}, [this] { save(); });
    command(menu, Needs::Editable, {"saveProjectAs", "Save &as…", "Ctrl+Shift+S", "Writes the project file under another name"}, [this] { saveAs(); });
    menu->addSeparator();
    command(menu, Needs::Project, {"closeProject", "&Close project", "Ctrl+W", "Back to the start page"}, [this] {
        if (letGo()) session_.close();
    });
    command(menu, Needs::Nothing, {"quit", "&Quit", "Ctrl+Q", "Ends the program"}, [this] { close(); });
}

void MainWindow::recentMenu() {
    recentMenu_->clear();
    for (const auto& file : memory_.recent()) recentMenu_->addAction(file, this, [this, file] { open(file); })->setEnabled(QFileInfo::exists(file));
    if (recentMenu_->isEmpty()) recentMenu_->addAction(tr("None yet"))->setEnabled(false);
}

void MainWindow::editMenu() {
    auto* menu = menuBar()->addMenu(tr("&Edit"));
    undo_ = command(menu, Needs::Editable, {"undo", "&Undo", "Ctrl+Z", "Takes back the last change of the project"}, [this] { session_.undo(); });
    redo_ = command(menu, Needs::Editable, {"redo", "&Redo", "Ctrl+Shift+Z", "Does again what was taken back"}, [this] { session_.redo(); });
    menu->addSeparator();
    selectionCommands(menu);
    menu->addSeparator();
    command(menu, Needs::Project, {"copyResults", "&Copy results", "Ctrl+Shift+C", "All points as a table, for a spreadsheet"}, [this] { QApplication::clipboard()->setText(results_->csv()); });
}

void MainWindow::viewMenu() {
    auto* menu = menuBar()->addMenu(tr("&View"));
    cameraCommands(menu);
    menu->addSeparator();
    auto* count = menu->addMenu(tr("Views at &once"));
    auto* counts = new QActionGroup(this);
    choice(count, counts, {"oneView", "One", "Ctrl+1", "A single view of the room"}, true, [this] { session_.setViewCount(1); });
    choice(count, counts, {"twoViews", "Two", "Ctrl+2", "Side by side"}, false, [this] { session_.setViewCount(2); });
    choice(count, counts, {"fourViews", "Four", "Ctrl+4", "Two by two"}, false, [this] { session_.setViewCount(4); });
    auto* linked = command(menu, Needs::Nothing, {"linkedCameras", "&Linked cameras", "Ctrl+L", "All views look from the same place"}, [this] {
        auto display = session_.display();
        display.linkedCameras = !display.linkedCameras;
        session_.setDisplay(display);
    });
    linked->setCheckable(true);
    linked->setChecked(session_.display().linkedCameras);

    auto* navigation = menu->addMenu(tr("&Navigation"));
    auto* ways = new QActionGroup(this);
    const auto way = [this](Navigation n) {
        return [this, n] {
            auto display = session_.display();
            display.navigation = n;
            session_.setDisplay(display);
        };
    };
    const auto now = session_.display().navigation;
    choice(navigation, ways, {"navigateOrbit", "&CAD orbit", "F6", "Drag turns the room about the point under the pointer"}, now == Navigation::Orbit, way(Navigation::Orbit));
    choice(navigation, ways, {"navigateWalk", "&Walk", "F7", "First person at eye height: W A S D and the mouse"}, now == Navigation::Walk, way(Navigation::Walk));
    choice(navigation, ways, {"navigateHolodeck", "&Holodeck", "F8", "Nearer to what is under the pointer, 10 % a frame"}, now == Navigation::Holodeck, way(Navigation::Holodeck));

    auto* units = menu->addMenu(tr("&Units"));
    const auto light = [this](LightUnit unit) {
        return [this, unit] {
            auto display = session_.display();
            display.units.light = unit;
            session_.setDisplay(display);
        };
    };
    const auto length = [this](LengthUnit unit) {
        return [this, unit] {
            auto display = session_.display();
            display.units.length = unit;
            session_.setDisplay(display);
        };
    };
    auto* lights = new QActionGroup(this);
    auto* lengths = new QActionGroup(this);
    const auto& shown = session_.display().units;
    choice(units, lights, {"unitLux", "&Lux, cd/m²", "", "Illuminance in lx"}, shown.light == LightUnit::Lux, light(LightUnit::Lux));
    choice(units, lights, {"unitFootcandle", "&Footcandles, footlamberts", "", "Illuminance in fc"}, shown.light == LightUnit::Footcandle, light(LightUnit::Footcandle));
    units->addSeparator();
    choice(units, lengths, {"unitMetres", "&Metres", "", "Lengths in m"}, shown.length == LengthUnit::Metres, length(LengthUnit::Metres));
    choice(units, lengths, {"unitFeet", "F&eet", "", "Lengths in ft"}, shown.length == LengthUnit::Feet, length(LengthUnit::Feet));

    auto* themes = menu->addMenu(tr("&Theme"));
    auto* looks = new QActionGroup(this);
    const auto theme = [this](Theme t) {
        return [this, t] {
            memory_.keepTheme(t);
            applyTheme(*qApp, t);
        };
    };
    choice(themes, looks, {"themeLight", "&Light", "", "For bright rooms"}, memory_.theme() == Theme::Light, theme(Theme::Light));
    choice(themes, looks, {"themeDark", "&Dark", "", "For dark rooms and pictures"}, memory_.theme() == Theme::Dark, theme(Theme::Dark));

    panelsMenu_ = menu->addMenu(tr("&Panels"));
    for (auto* dock : docks_) panelsMenu_->addAction(dock->toggleViewAction());
    menu->addSeparator();
    command(menu, Needs::Nothing, {"fullScreen", "F&ull screen", "F11", "The window without its frame"}, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
}

void MainWindow::cameraCommands(QMenu* menu) {
    // F, 1, 3 and 7 alone are the views' own while they have the keyboard.
    command(menu, Needs::Project, {"fitView", "&Fit all", "Ctrl+F", "The whole project in view"}, [this] { views_->fit(); });
    auto* from = menu->addMenu(tr("&Look from"));
    const std::pair<CommandText, Side> sides[] = {{{"lookTop", "&Above", "Ctrl+7", "The plan"}, Side::Top},
                                                  {{"lookFront", "&South", "Ctrl+Shift+1", "From the front"}, Side::Front},
                                                  {{"lookBack", "&North", "", "From behind"}, Side::Back},
                                                  {{"lookRight", "&East", "Ctrl+3", "From the right"}, Side::Right},
                                                  {{"lookLeft", "&West", "", "From the left"}, Side::Left},
                                                  {{"lookCorner", "&Corner", "Ctrl+0", "From above a corner"}, Side::Iso}};
    for (const auto& [text, side] : sides) command(from, Needs::Project, text, [this, side = side] { views_->lookFrom(side); });
    namedViewsMenu_ = menu->addMenu(tr("Na&med views"));
    connect(namedViewsMenu_, &QMenu::aboutToShow, this, &MainWindow::namedViewsMenu);
}

void MainWindow::namedViewsMenu() {
    namedViewsMenu_->clear();
    if (const auto loaded = session_.project())
        for (const auto& view : loaded->project.views) namedViewsMenu_->addAction(QString::fromStdString(view.name), this, [this, view] { views_->goTo(view); });
    if (namedViewsMenu_->isEmpty()) namedViewsMenu_->addAction(tr("None yet"))->setEnabled(false);
}

void MainWindow::calculateMenu() {
    auto* menu = menuBar()->addMenu(tr("&Calculate"));
    command(menu, Needs::Project, {"solve", "&Solve", "F5", "Illuminance on all calculation surfaces, as the panel Solve says"}, [this] { solve_->start(); });
    command(menu, Needs::Project, {"render", "&Render picture", "F12", "The chosen view, as the page Pictures says"}, [this] {
        showWorkspace(Workspace::Picture);
        picture_->render();
    });
    command(menu, Needs::Project, {"buildVolume", "Build &volume", "F9", "The light at any point and direction, as the panel Volume says"}, [this] {
        showDock(volumeDock_);
        volume_->build();
    });
    command(menu, Needs::Project, {"compare", "&Compare algorithms", "Ctrl+Shift+A", "Error against run time, on the page Compare"}, [this] { showWorkspace(Workspace::Compare); });
    command(menu, Needs::Project, {"report", "R&eport", "Ctrl+P", "What the client gets, on the page Report"}, [this] { showWorkspace(Workspace::Report); });
    command(menu, Needs::Nothing, {"stopAll", "S&top everything", "Ctrl+.", "Cancels all background work; what is known is kept"}, [this] { session_.place.jobs.cancelAll(); });
}

void MainWindow::helpMenu() {
    auto* menu = menuBar()->addMenu(tr("&Help"));
    command(menu, Needs::Nothing, {"shortcuts", "&Keyboard shortcuts", "F1", "Every command with its keys"}, [this] { (new ShortcutsDialog(commands_, this))->open(); });
    command(menu, Needs::Nothing, {"about", "&About Luxdeck", "", "Version and licence"}, [this] {
        QMessageBox::about(this, tr("About Luxdeck"), tr("<b>Luxdeck %1</b><p>Lighting design in which every number carries its error and its run time.<p>BSD-3-Clause.").arg(QString::fromLatin1(kVersion)));
    });
}

void MainWindow::refreshCommands() {
    const bool open = session_.project() != nullptr || !session_.document().file().empty();
    for (auto* action : needProject_) action->setEnabled(open);
    for (auto* action : needEditable_) action->setEnabled(open && session_.editable());
    const auto& document = session_.document();
    undo_->setEnabled(document.canUndo());
    redo_->setEnabled(document.canRedo());
    undo_->setIconText(tr("Undo"));
    redo_->setIconText(tr("Redo"));
    undo_->setText(document.canUndo() ? tr("&Undo %1").arg(QString::fromStdString(document.undoName())) : tr("&Undo"));
    redo_->setText(document.canRedo() ? tr("&Redo %1").arg(QString::fromStdString(document.redoName())) : tr("&Redo"));
}

}  // namespace luxdeck::gui
