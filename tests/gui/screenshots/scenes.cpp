#include "tests/gui/screenshots/scenes.h"

#include "gui/app/theme.h"
#include "gui/panels/import_dialog.h"
#include "gui/view3d/view_area.h"
#include "gui/view3d/view_area.h"
#include "tests/gui/screenshots/stage.h"

#include <QApplication>
#include <QScreen>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace luxdeck::gui {

namespace {

constexpr int kJpegQuality = 90;

bool startPage(Stage&) { return true; }

bool room(Stage& stage) {
    if (!stage.open("office") || !stage.solve(0.03)) return false;
    stage.raise("showDock");
    return true;
}

bool valuesAndIntervals(Stage& stage) {
    if (!stage.open("office") || !stage.solve(0.03)) return false;
    stage.view([](ViewSettings& view) { view.values = view.intervals = true; });
    stage.session().select({Thing::Grid, 6});  // the meeting table
    stage.look({12.3, 5.75, 2.75}, {12.3, 7.05, 0.8});
    stage.raise("showDock");
    return true;
}

bool walkingIn(Stage& stage) {
    if (!stage.open("office") || !stage.solve(0.03)) return false;
    stage.window.window->views().goTo(stage.session().project()->project.views[0]);
    return true;
}

bool section(Stage& stage) {
    if (!stage.open("office") || !stage.solve(0.03)) return false;
    stage.view([](ViewSettings& view) {
        view.section = {true, {0, -1, 0}, 0.6};
        view.hideCeiling = false;
    });
    stage.look({5.2, -5.2, 3.6}, {7.0, 4, 1.0});
    stage.raise("showDock");
    return true;
}

bool candelaSolids(Stage& stage) {
    if (!stage.open("office")) return false;
    stage.view([](ViewSettings& view) {
        view.candelaSolids = true;
        view.grids = view.verdicts = false;
    });
    stage.session().select({Thing::Luminaire, 11});
    stage.look({-0.6, -0.6, 2.6}, {3.4, 3.4, 1.75});
    stage.raise("showDock");
    stage.giveProperties();
    return true;
}

bool luminaireType(Stage& stage) {
    if (!stage.open("office")) return false;
    stage.view([](ViewSettings& view) { view.grids = false; });
    stage.session().select({Thing::LuminaireType, 1});
    stage.raise("lightingDock");
    stage.giveProperties();
    return true;
}

/// The project's volume at once, small enough to be made in seconds.
bool buildVolume(Stage& stage) {
    VolumeRequest request;
    const auto settings = volumeSettingsOf(stage.session().project()->project, "");
    if (!settings) return false;
    request.settings = *settings;
    request.settings.side = 11;
    request.settings.samplesPerBin = std::min(request.settings.samplesPerBin, 8U);
    stage.session().volumes.build(request);
    if (!stage.window.untilIdle() || stage.session().volumes.shown() == nullptr) return false;
    stage.view([](ViewSettings& view) { view.grids = view.verdicts = false; });
    stage.raise("volumeDock");
    return true;
}

bool glyphs(Stage& stage) {
    if (!stage.open("office") || !buildVolume(stage)) return false;
    stage.view([](ViewSettings& view) {
        view.glyphs = true;
        view.glyphRadiusM = 0.1;
    });
    stage.look({1.0, 8.0, 1.9}, {7, 3.2, 1.0});
    return true;
}

bool directAgainstIndirect(Stage& stage) {
    if (!stage.open("office") || !buildVolume(stage)) return false;
    stage.view([](ViewSettings& view) {
        view.glyphs = true;
        view.glyphRadiusM = 0.12;
    });
    stage.window.click("directIndirect");
    stage.look({0.8, 8.2, 2.2}, {6, 3.2, 1.0});
    return true;
}

bool slice(Stage& stage) {
    if (!stage.open("office") || !buildVolume(stage)) return false;
    stage.window.click("sliceOn");
    stage.view([](ViewSettings& view) {
        view.isosurface = true;
        view.isosurfaceLux = 800;
        view.luminaires = false;
    });
    stage.revealInDock("volumeDock", "isosurfaceLevel");
    return true;
}

bool lighting(Stage& stage) {
    if (!stage.open("gallery") || !stage.solve(0.03, true)) return false;
    stage.raise("lightingDock");
    return true;
}

bool furniture(Stage& stage) {
    if (!stage.open("office") || !stage.solve(0.03)) return false;
    auto& hand = stage.session().furnishing;
    hand.begin("Meeting table");
    if (!stage.window.untilIdle()) return false;
    Pose pose;
    pose.moveM = Vec3(-3, -1.2F, 0);
    hand.moveTo(pose);
    hand.estimateRoom();
    if (!stage.window.untilIdle()) return false;
    stage.view([](ViewSettings& view) { view.verdicts = view.luminaires = false; });
    stage.look({6.6, 8.1, 2.8}, {9.5, 5.7, 0.6});
    stage.raise("furnitureDock");
    return true;
}

bool import(Stage& stage, const std::filesystem::path& file) {
    if (!stage.open("office")) return false;
    auto* dialog = new ImportDialog(stage.session(), {file}, stage.window.window.get());
    dialog->open();
    stage.subject = dialog;
    return stage.window.untilIdle();
}

bool importing(Stage& stage) { return import(stage, stage.folder.path() / "office" / "luminaires" / "a_panel.ies"); }

bool importingBroken(Stage& stage) {
    const auto file = stage.folder.path() / "downlight.ies";
    std::filesystem::copy_file(std::filesystem::path(LUXDECK_SOURCE_DIR) / "tests/fuzz/corpus/ies/bad_not_numbers.ies", file);
    const bool shown = import(stage, file);
    if (shown) stage.subject->resize(640, 240);
    return shown;
}

bool rendered(Stage& stage, const std::string& algorithm, double seconds) {
    PictureRequest request{stage.session().project()->project.views[0], {}};
    request.view.width = 750, request.view.height = 500;
    request.settings.algorithm = algorithm;
    request.settings.targetError = 0.02;
    request.settings.timeSeconds = seconds;
    return stage.session().pictures.render(request) && stage.window.untilIdle();
}

bool picture(Stage& stage) {
    if (!stage.open("office") || !rendered(stage, "irradiance_cache", 25)) return false;
    stage.page(1);
    return true;
}

bool falseColours(Stage& stage) {
    if (!picture(stage)) return false;
    stage.window.click("lookFalseColour");
    return stage.window.untilIdle();
}

bool swipe(Stage& stage) {
    if (!stage.open("office") || !rendered(stage, "direct", 6)) return false;
    const auto first = stage.session().pictures.all().front().number;
    if (!rendered(stage, "irradiance_cache", 20)) return false;
    stage.session().pictures.show(1, first);
    stage.page(1);
    return stage.window.untilIdle();
}

bool comparing(Stage& stage) {
    if (!stage.open("office")) return false;
    CompareSettings settings;
    settings.algorithms = {"path", "shared", "radiosity"};
    settings.budgetSeconds = 1;
    settings.rungs = 4, settings.repetitions = 3;
    settings.referenceError = 0.02;
    auto& session = stage.session();
    session.comparing.start(settings);
    if (!stage.window.untilIdle() || !session.comparing.result() || session.comparing.result()->runs.empty()) return false;
    session.comparing.look({session.comparing.result()->runs.front().subject, "path", 2});
    stage.page(2);
    return stage.window.untilIdle();
}

bool reporting(Stage& stage) {
    if (!stage.open("office") || !stage.solve(0.03)) return false;
    ReportChoice choice;
    choice.views = {"cover", "desk"};
    choice.viewSeconds = 5;
    choice.viewAlgorithm = "irradiance_cache";
    stage.session().reporting.make(choice);
    stage.page(3);
    return stage.window.untilIdle() && stage.session().reporting.pages() != nullptr;
}

bool dark(Stage& stage) {
    applyTheme(*qApp, Theme::Dark);
    return room(stage);
}

bool footcandles(Stage& stage) {
    if (!room(stage)) return false;
    auto display = stage.session().display();
    display.units = {LightUnit::Footcandle, LengthUnit::Feet};
    stage.session().setDisplay(display);
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
        {"values-and-intervals", valuesAndIntervals},
        {"inside", walkingIn},
        {"section", section},
        {"candela-solids", candelaSolids},
        {"luminaire-type", luminaireType},
        {"glyphs", glyphs},
        {"direct-indirect", directAgainstIndirect},
        {"slice", slice},
        {"lighting", lighting},
        {"furniture", furniture},
        {"import", importing},
        {"import-broken", importingBroken},
        {"picture", picture},
        {"false-colour", falseColours},
        {"swipe", swipe},
        {"compare", comparing},
        {"report", reporting},
        {"dark", dark},
        {"footcandles", footcandles},
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
    (void)stage.window.untilIdle();  // what is drawn is made beside the window
    Stage::settle(1000);
    (void)stage.window.window->views().picture();  // whatever was still to be drawn is
    Stage::settle(1500);
    auto* subject = stage.subject != nullptr ? stage.subject : stage.window.window.get();
    // From the screen, not from the widgets: what OpenGL drew and what lies over it are in it as a user sees them.
    const auto at = subject->mapToGlobal(QPoint(0, 0));
    const auto picture = subject->screen()->grabWindow(0, at.x(), at.y(), subject->width(), subject->height());
    return picture.save(QString::fromStdString(folder + "/" + scene.name + ".jpg"), "JPG", kJpegQuality);
}

}  // namespace luxdeck::gui
