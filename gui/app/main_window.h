#pragma once

#include "gui/app/memory.h"
#include "gui/session/session.h"

#include <QElapsedTimer>
#include <QMainWindow>

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

class QActionGroup;
class QLabel;
class QStackedWidget;
class QTabWidget;
class QTimer;

namespace luxdeck::gui {

class ComparePanel;
class FurniturePanel;
class PicturePanel;
class ReportPanel;
class ResultsPanel;
class ShowPanel;
class SolvePanel;
class StartPage;
class ViewArea;
class VolumePanel;

/// The window: a room in the middle, docks around it, everything reachable by menu and key. What happens is the session's;
/// this class arranges.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Memory& memory, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Session& session() { return session_; }
    [[nodiscard]] ViewArea& views() { return *views_; }
    /// Opens a project or a bare scene. What an earlier session could not save is offered.
    void open(const QString& file);

    enum class Workspace { Room, Picture, Compare, Report };
    void showWorkspace(Workspace workspace);

    /// Every action, by menu: for the shortcuts' list.
    [[nodiscard]] const std::vector<QAction*>& commands() const { return commands_; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    // window_menus.cpp
    void makeMenus();
    void fileMenu();
    void recentMenu();
    void cameraCommands(QMenu* menu);
    void namedViewsMenu();
    void editMenu();
    void viewMenu();
    void calculateMenu();
    void helpMenu();

    // window_edits.cpp
    void insertMenu();
    void luminaireMenu();
    void selectionCommands(QMenu* menu);
    void change(const std::string& what, const Session::Edit& edit);
    void drag(const std::string& object, const Pose& pose, bool done);
    void removeSelected();
    void switchSelected();
    void insertLuminaire(const std::string& type);
    void insertSurface();
    void import(const QStringList& files);
    enum class Needs { Nothing, Project, Editable };
    struct CommandText {
        const char *name, *text, *keys, *tip;
    };
    QAction* command(QMenu* menu, Needs needs, const CommandText& text, std::function<void()> run);
    /// One of several that exclude each other, ticked where it holds.
    QAction* choice(QMenu* menu, QActionGroup* group, const CommandText& text, bool on, std::function<void()> run);
    void refreshCommands();

    // window_files.cpp
    void askToOpen();
    void askForNew();
    bool save();
    bool saveAs();
    /// Saved, or thrown away on purpose. False: the user stays.
    bool letGo();
    void recover(const QString& file);

    // window_docks.cpp
    void makeWorkspaces();
    void makeDocks();
    static void showDock(QDockWidget* dock);
    QDockWidget* dock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area);
    void leaveOutWhatIsNotThere();
    static void leaveOut(QDockWidget* dock, bool out);

    void deliver();
    void heard(Change change);
    void refreshTitle();
    void showErrors();

    Memory& memory_;
    std::atomic<bool> woken_{false};  // by a job; delivered soon
    QElapsedTimer delivered_;
    Session session_;
    std::size_t errorsSeen_ = 0;

    QStackedWidget* pages_;
    StartPage* start_;
    QTabWidget* workspaces_;
    QMainWindow* room_;  // the page Room: views in the middle, docks around them
    ViewArea* views_;
    PicturePanel* picture_;
    ComparePanel* compare_;
    ReportPanel* report_;
    ResultsPanel* results_;
    ShowPanel* show_;
    SolvePanel* solve_;
    FurniturePanel* furniture_;
    VolumePanel* volume_;
    QLabel* probe_;
    std::vector<QDockWidget*> docks_;
    QDockWidget *lightingDock_ = nullptr, *furnitureDock_ = nullptr, *volumeDock_ = nullptr;
    QMenu *panelsMenu_ = nullptr, *recentMenu_ = nullptr, *namedViewsMenu_ = nullptr, *luminaireMenu_ = nullptr;

    std::vector<QAction*> commands_, needProject_, needEditable_;
    QAction *save_ = nullptr, *undo_ = nullptr, *redo_ = nullptr;
};

}  // namespace luxdeck::gui
