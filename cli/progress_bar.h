#pragma once

#include "engine/core/progress.h"

#include <chrono>
#include <string>

namespace luxdeck::cli {

/// Shows progress on stderr: a bar that redraws itself on a terminal, a line every few seconds elsewhere.
class ProgressBar {
public:
    explicit ProgressBar(bool quiet);
    ~ProgressBar() { finish(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(const ProgressState& state);
    /// Ends the bar's line, so that messages start on their own.
    void finish();

private:
    using Clock = std::chrono::steady_clock;

    bool quiet_;
    bool terminal_;
    bool open_ = false;
    std::string stage_;
    Clock::time_point last_{};
};

/// "1:05" of seconds.
std::string clockText(double seconds);

}  // namespace luxdeck::cli
