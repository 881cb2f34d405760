#pragma once

#include "engine/core/progress.h"
#include "engine/core/stopwatch.h"

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace luxdeck::gui {

/// Look: what makes a picture or page visible, quick and often; not worth a word to the user.
enum class JobKind { Load, Solve, Render, Volume, Furniture, Compare, Report, Save, Look, Import };

/// What a running job says of itself.
struct JobState {
    std::uint64_t id = 0;
    JobKind kind = JobKind::Load;
    std::string title;          ///< "Solving", "Rendering cover"
    ProgressState progress;
    double seconds = 0;         ///< since it began
    bool cancelled = false;     ///< asked to stop, and not yet done
};

/// Long work on threads of its own, which yield to the window's. Everything else happens on one thread, the owner's: a
/// job's words come when deliver() is called there, in the order in which they were said.
class Jobs {
public:
    using Delivery = std::function<void()>;
    /// Says something from the job's thread: the delivery runs on the owner's.
    using Tell = std::function<void(Delivery)>;
    /// The work; what it returns is delivered last.
    using Work = std::function<Delivery(const Progress&, const Tell&)>;

    /// wake  called from any thread when there is something to deliver
    explicit Jobs(std::function<void()> wake);
    /// Cancels and waits.
    ~Jobs();
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    std::uint64_t start(JobKind kind, std::string title, Work work);
    void cancel(std::uint64_t id);
    void cancel(JobKind kind);
    void cancelAll();
    /// Stops it and hears nothing more of it: what it was for is gone.
    void abandon(std::uint64_t id);
    /// The same of all but those that save: how saving ended is always told.
    void abandonAll();

    [[nodiscard]] bool running(JobKind kind) const;
    [[nodiscard]] bool idle() const { return jobs_.empty(); }
    [[nodiscard]] std::vector<JobState> states() const;

    /// Runs what was said since the last time. Returns whether there was anything.
    bool deliver();

private:
    struct Job;
    /// What a job said, and whether that was its last word.
    struct Said {
        std::uint64_t job;
        Delivery delivery;
        bool last;
    };
    void say(Said said);
    [[nodiscard]] std::list<std::unique_ptr<Job>>::iterator find(std::uint64_t id);

    std::function<void()> wake_;
    std::list<std::unique_ptr<Job>> jobs_;
    std::mutex mutex_;                  // of said_
    std::vector<Said> said_;
    std::uint64_t next_ = 1;
};

}  // namespace luxdeck::gui
