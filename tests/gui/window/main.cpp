// Tests of the window run on an X server of their own, so that they are the same on any machine: with or without a
// display, whatever is on it.
#include "gui/view3d/graphics.h"

#include <QApplication>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

/// An Xvfb that ends with this process.
class VirtualDisplay {
public:
    /// False: it could not be started.
    bool start() {
        int ends[2];
        if (pipe(ends) != 0) return false;
        child_ = fork();
        if (child_ == 0) {
            prctl(PR_SET_PDEATHSIG, SIGTERM);  // also when the tests are killed
            close(ends[0]);
            const auto number = std::to_string(ends[1]);
            execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1600x1000x24", "-nolisten", "tcp", "-noreset", nullptr);
            _exit(127);
        }
        close(ends[1]);
        std::string display;
        for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) display += c;
        close(ends[0]);
        if (display.empty()) return false;
        setenv("DISPLAY", (":" + display).c_str(), 1);
        return true;
    }
    ~VirtualDisplay() {
        if (child_ <= 0) return;
        kill(child_, SIGTERM);
        waitpid(child_, nullptr, 0);
    }

private:
    pid_t child_ = -1;
};

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
    VirtualDisplay display;
    if (!display.start()) {
        std::cerr << "Xvfb cannot be started: install xvfb (./dev test does)\n";
        return 1;
    }
    // What the program remembers of its user goes into a folder of this run.
    char folder[] = "/tmp/luxdeck-window-XXXXXX";
    if (mkdtemp(folder) == nullptr) return 1;
    for (const char* name : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"}) setenv(name, folder, 1);
    setenv("XDG_RUNTIME_DIR", folder, 1);
    setenv("LUXDECK_PROJECTS", LUXDECK_SOURCE_DIR "/projects", 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    luxdeck::gui::prepareGraphics();
    QApplication application(argc, argv);
    const int status = RUN_ALL_TESTS();
    std::filesystem::remove_all(folder);
    return status;
}
