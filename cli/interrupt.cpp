#include "cli/interrupt.h"

#include <atomic>
#include <csignal>
#include <unistd.h>

namespace luxdeck::cli {

namespace {

std::atomic<Progress*> g_progress{nullptr};

extern "C" void onInterrupt(int) {
    Progress* progress = g_progress.load();
    if (progress == nullptr || progress->cancelled()) _exit(130);
    progress->cancel();
}

}  // namespace

InterruptGuard::InterruptGuard(Progress& progress) {
    g_progress = &progress;
    struct sigaction action {};
    action.sa_handler = onInterrupt;  // no SA_RESTART: a read of stdin must end
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);  // ulimit -f: like a full disk
}

InterruptGuard::~InterruptGuard() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    g_progress = nullptr;
}

}  // namespace luxdeck::cli
