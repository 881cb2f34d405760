// Makes the pictures of README and manual: opens samples, works as a designer would, and keeps what the screen shows.
//   luxdeck_screenshots FOLDER [NAME...]
#include "gui/app/theme.h"
#include "gui/view3d/graphics.h"
#include "tests/gui/screenshots/scenes.h"
#include "tests/support/virtual_display.h"

#include <QApplication>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

int main(int argc, char** argv) {
    using namespace luxdeck;
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.empty()) {
        std::cerr << "expected a folder for the pictures, and then names of those to make (none: all)\n";
        return 2;
    }
    test::VirtualDisplay display;
    if (!display.start()) {
        std::cerr << "Xvfb cannot be started: install xvfb (./dev screenshots does)\n";
        return 1;
    }
    const test::OwnUser user;
    setenv("LUXDECK_PROJECTS", LUXDECK_SOURCE_DIR "/projects", 0);
    gui::prepareGraphics();
    QApplication application(argc, argv);
    gui::applyTheme(application, gui::Theme::Light);
    std::filesystem::create_directories(arguments.front());
    const std::vector<std::string> wanted(arguments.begin() + 1, arguments.end());
    int missing = 0;
    for (const auto& scene : gui::screenshotScenes()) {
        const auto asked = [&](const std::string& name) { return name == scene.name; };
        if (!wanted.empty() && std::none_of(wanted.begin(), wanted.end(), asked)) continue;
        const bool made = gui::makeScreenshot(scene, arguments.front());
        std::cout << scene.name << (made ? "" : ": FAILED") << std::endl;
        missing += made ? 0 : 1;
    }
    return missing == 0 ? 0 : 1;
}
