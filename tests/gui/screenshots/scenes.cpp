#include "tests/gui/screenshots/scenes.h"

#include "gui/view3d/view_area.h"
#include "tests/gui/screenshots/stage.h"

#include <QDockWidget>
#include <QScreen>

#include <iostream>

namespace luxdeck::gui {

namespace {

constexpr int kJpegQuality = 90;

bool startPage(Stage&) { return true; }

bool room(Stage& stage) {
    if (!stage.open("office") || !stage.solve(0.03)) return false;
    stage.window.find<QDockWidget>("showDock")->raise();
    return true;
}

bool walkingIn(Stage& stage) {
    if (!stage.open("office") || !stage.solve(0.03)) return false;
    stage.window.window->views().goTo(stage.session().project()->project.views[0]);
    return true;
}

bool shortcuts(Stage& stage) {
    stage.window.command("shortcuts");
    stage.settle();
    stage.subject = stage.window.find("shortcutsDialog");
    return true;
}

}  // namespace

const std::vector<ScreenshotScene>& screenshotScenes() {
    static const std::vector<ScreenshotScene> scenes{
        {"start-page", startPage},
        {"room", room},
        {"inside", walkingIn},
        {"shortcuts", shortcuts},
    };
    return scenes;
}

bool makeScreenshot(const ScreenshotScene& scene, const std::string& folder) {
    Stage stage;
    if (!scene.act(stage)) {
        for (const auto& entry : stage.session().place.log()) std::cerr << entry.text << "\n";
        return false;
    }
    Stage::settle(1000);
    auto* subject = stage.subject != nullptr ? stage.subject : stage.window.window.get();
    // From the screen, not from the widgets: what OpenGL drew and what lies over it are in it as a user sees them.
    const auto picture = subject->screen()->grabWindow(0, subject->x(), subject->y(), subject->width(), subject->height());
    return picture.save(QString::fromStdString(folder + "/" + scene.name + ".jpg"), "JPG", kJpegQuality);
}

}  // namespace luxdeck::gui
