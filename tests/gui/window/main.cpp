// Tests of the window run on an X server of their own, so that they are the same on any machine.
#include "gui/view3d/graphics.h"
#include "tests/support/virtual_display.h"

#include <QApplication>
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <iostream>

namespace {

bool onlyLists(int argc, char** argv) {
    for (int i = 1; i < argc; ++i)
        if (std::strcmp(argv[i], "--gtest_list_tests") == 0) return true;
    return false;
}

}  // namespace

int main(int argc, char** argv) {
    const bool listing = onlyLists(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    if (listing) return RUN_ALL_TESTS();
    luxdeck::test::VirtualDisplay display;
    if (!display.start()) {
        std::cerr << "Xvfb cannot be started: install xvfb (./dev test does)\n";
        return 1;
    }
    const luxdeck::test::OwnUser user;
    setenv("LUXDECK_PROJECTS", LUXDECK_SOURCE_DIR "/projects", 1);
    luxdeck::gui::prepareGraphics();
    QApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
