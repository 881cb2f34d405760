#include "cli/progress_bar.h"

#include "cli/streams.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unistd.h>

namespace luxdeck::cli {

namespace {

constexpr int kBarWidth = 24;
constexpr auto kRedraw = std::chrono::milliseconds(100);
constexpr auto kLine = std::chrono::seconds(3);

std::string bar(double fraction) {
    const int full = static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * kBarWidth));
    std::string text;
    for (int i = 0; i < kBarWidth; ++i) text += i < full ? "█" : "░";
    return text;
}

std::string describe(const ProgressState& s, bool withBar) {
    std::string text = s.stage;
    if (s.fraction >= 0) text += fmt::format("  {}{:3.0f} %", withBar ? bar(s.fraction) + " " : "", 100 * s.fraction);
    if (s.rate >= 0) text += fmt::format("  {:.2f} {}", s.rate, s.rateUnit);
    if (s.errorPercent >= 0 && std::isfinite(s.errorPercent)) text += fmt::format("  error {:.2g} %", s.errorPercent);
    if (s.secondsLeft >= 0 && std::isfinite(s.secondsLeft)) text += fmt::format("  {} left", clockText(s.secondsLeft));
    return text;
}

}  // namespace

std::string clockText(double seconds) {
    const auto whole = static_cast<long>(std::lround(std::min(seconds, 1e8)));
    return whole >= 3600 ? fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60)
                         : fmt::format("{}:{:02}", whole / 60, whole % 60);
}

ProgressBar::ProgressBar(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressBar::show(const ProgressState& state) {
    if (quiet_) return;
    const auto now = Clock::now();
    const bool newStage = state.stage != stage_;
    if (!newStage && now - last_ < (terminal_ ? Clock::duration(kRedraw) : Clock::duration(kLine))) return;
    if (newStage) finish();
    stage_ = state.stage;
    last_ = now;
    if (terminal_) {
        say("\r\033[K" + describe(state, true));
        open_ = true;
    } else {
        say(describe(state, false) + "\n");
    }
}

void ProgressBar::finish() {
    if (open_) say("\r\033[K");
    open_ = false;
    stage_.clear();
}

}  // namespace luxdeck::cli
