#pragma once

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace luxdeck::test {

/// An X server of its own (Xvfb, 1600 x 1000), which ends with this process: windows are the same on any machine, with or
/// without a display, whatever is on it. Programs draw on it by Mesa's software renderer.
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
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
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

/// What a program remembers of its user goes into a folder of this run, which is gone at the end.
class OwnUser {
public:
    OwnUser() {
        std::string pattern = (std::filesystem::temp_directory_path() / "luxdeck-user-XXXXXX").string();
        folder_ = mkdtemp(pattern.data());
        for (const char* name : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"}) setenv(name, folder_.c_str(), 1);
    }
    ~OwnUser() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    OwnUser(const OwnUser&) = delete;
    OwnUser& operator=(const OwnUser&) = delete;

private:
    std::filesystem::path folder_;
};

}  // namespace luxdeck::test
