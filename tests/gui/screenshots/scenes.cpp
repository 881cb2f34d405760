#include "tests/gui/screenshots/scenes.h"

#include "gui/panels/import_dialog.h"
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

/// The project's volume at once, small enough to be made in seconds.
bool buildVolume(Stage& stage) {
    VolumeRequest request;
    const auto settings = volumeSettingsOf(stage.session().project()->project, "");
    if (!settings) return false;
    request.settings = *settings;
    stage.session().volumes.build(request);
    return stage.window.untilIdle() && stage.session().volumes.shown() != nullptr;
}

bool glyphs(Stage& stage) {
    if (!stage.open("office") || !buildVolume(stage)) return false;
    stage.view([](ViewSettings& view) {
        view.glyphs = true;
        view.grids = false;
    });
    stage.window.find<QDockWidget>("volumeDock")->raise();
    return true;
}

bool directAgainstIndirect(Stage& stage) {
    if (!stage.open("office") || !buildVolume(stage)) return false;
    stage.session().setViewCount(2);
    for (std::size_t i = 0; i < 2; ++i)
        stage.view([&](ViewSettings& view) {
            view.glyphs = true;
            view.grids = false;
            view.part = i == 0 ? LightPart::Direct : LightPart::Indirect;
        }, i);
    stage.window.find<QDockWidget>("volumeDock")->raise();
    return true;
}

bool lighting(Stage& stage) {
    if (!stage.open("gallery") || !stage.solve(0.03, true)) return false;
    stage.window.find<QDockWidget>("lightingDock")->raise();
    return true;
}

bool furniture(Stage& stage) {
    if (!stage.open("office") || !stage.solve(0.03)) return false;
    stage.session().furnishing.begin("Meeting table");
    if (!stage.window.untilIdle()) return false;
    Pose pose;
    pose.moveM = Vec3(-3, -1.2F, 0);
    stage.session().furnishing.moveTo(pose);
    auto* dock = stage.window.find<QDockWidget>("furnitureDock");
    dock->show();
    dock->raise();
    return true;
}

bool importing(Stage& stage) {
    if (!stage.open("office")) return false;
    auto* dialog = new ImportDialog(stage.session(), {stage.folder.path() / "office" / "luminaires" / "a_panel.ies"}, stage.window.window.get());
    dialog->open();
    stage.subject = dialog;
    return stage.window.untilIdle();
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
        {"glyphs", glyphs},
        {"direct-indirect", directAgainstIndirect},
        {"lighting", lighting},
        {"furniture", furniture},
        {"import", importing},
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
