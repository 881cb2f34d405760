#pragma once

#include "gui/app/theme.h"
#include "gui/view3d/view_area.h"
#include "tests/gui/window/open_window.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QTabWidget>

#include <functional>
#include <string>

namespace luxdeck::gui {

/// A window on a screen of its own with a copy of a sample project, and what scenes do with it.
class Stage {
public:
    Stage() {
        window.window->resize(1440, 900);
        settle();
    }
    /// What a scene changed for good is as at first for the next one.
    ~Stage() {
        applyTheme(*qApp, Theme::Light);
        session().setDisplay(Display{});
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    test::OwnFolder folder;
    test::OpenWindow window;
    /// Taken instead of the window, when a scene is about a part of it.
    QWidget* subject = nullptr;

    [[nodiscard]] Session& session() { return window.session(); }
    [[nodiscard]] bool open(const std::string& sample) {
        const bool opened = window.open(folder.sample(sample));
        settle();
        return opened;
    }
    /// Illuminance to a relative error.
    [[nodiscard]] bool solve(double target, bool byLuminaire = false) {
        SolveSettings settings;
        settings.algorithm = byLuminaire ? "path" : "shared";
        settings.targetError = target;
        settings.timeSeconds = 90;
        settings.byLuminaire = byLuminaire;
        session().solving.start(settings);
        return window.untilIdle() && session().solving.result() != nullptr;
    }
    void view(const std::function<void(ViewSettings&)>& edit, std::size_t index = 0) {
        auto settings = session().views()[index];
        edit(settings);
        session().setView(index, settings);
    }
    /// Looks from one point to another [m, user coordinates].
    void look(const Vec3d& from, const Vec3d& to) {
        View view;
        view.position = from;
        view.direction = (to - from).normalized();
        view.verticalFovDeg = 55;
        window.window->views().goTo(view);
    }
    void raise(const char* dock) const {
        auto* panel = window.find<QDockWidget>(dock);
        panel->show();
        panel->raise();
    }
    /// Nearly all of the left side for the properties.
    void giveProperties() const {
        auto* properties = window.find<QDockWidget>("propertiesDock");
        if (auto* room = qobject_cast<QMainWindow*>(properties->parentWidget())) room->resizeDocks({window.find<QDockWidget>("projectDock"), properties}, {100, 560}, Qt::Vertical);
    }
    /// Scrolls a panel to one of its widgets.
    void revealInDock(const char* dock, const char* widget) const {
        raise(dock);
        settle();
        if (auto* area = qobject_cast<QScrollArea*>(window.find<QDockWidget>(dock)->widget())) area->ensureWidgetVisible(window.find(widget));
    }
    /// Room, Pictures, Compare, Report.
    void page(int index) const {
        window.find<QTabWidget>("workspaces")->setCurrentIndex(index);
        settle();
    }
    /// Lets everything that was asked for be drawn.
    static void settle(int ms = 400) { QTest::qWait(ms); }
};

}  // namespace luxdeck::gui
