#pragma once

#include "tests/gui/window/open_window.h"

#include <QPixmap>

#include <string>

namespace luxdeck::gui {

/// A window on a screen of its own with a copy of a sample project, and what scenes do with it.
class Stage {
public:
    Stage() {
        window.window->resize(1360, 850);
        settle();
    }

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
    /// Lets everything that was asked for be drawn.
    static void settle(int ms = 400) { QTest::qWait(ms); }
};

}  // namespace luxdeck::gui
