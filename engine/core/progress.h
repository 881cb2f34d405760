#pragma once

#include <atomic>
#include <functional>
#include <string>

namespace luxdeck {

/// What long work tells about itself. Numbers that are not known are negative.
struct ProgressState {
    std::string stage;             // "solving", "rendering" ...
    double fraction = -1;          // of the work done, 0..1
    double rate = -1;              // per second
    std::string rateUnit;          // "Mray", "samples" ...
    double errorPercent = -1;      // current error, % (95 % interval)
    double secondsLeft = -1;       // predicted
};

/// The ear of long work: hears its progress and may ask it to stop. Work polls cancelled() at least
/// every few milliseconds and then returns what it has, marked incomplete.
class Progress {
public:
    using Listener = std::function<void(const ProgressState&)>;

    Progress() = default;
    explicit Progress(Listener listener) : listener_(std::move(listener)) {}

    /// Called by the working thread only, a few times a second at most.
    void report(const ProgressState& state) const {
        if (listener_) listener_(state);
    }
    /// Safe from any thread and from signal handlers.
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

private:
    Listener listener_;
    std::atomic<bool> cancelled_{false};
    static_assert(std::atomic<bool>::is_always_lock_free);
};

}  // namespace luxdeck
