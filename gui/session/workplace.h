#pragma once

#include "engine/algorithms/lit_project.h"
#include "gui/session/jobs.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::gui {

/// What changed: whoever shows it looks again.
enum class Change {
    Document,    ///< text, undo, saved or not
    Project,     ///< the scene that is shown; null after closing
    Solve,       ///< illuminance on the calculation surfaces
    Pictures,
    Volumes,
    Comparison,
    Import,      ///< what dropped files are
    Furniture,   ///< where a moved object is, and its light
    Report,
    Selection,
    Display,     ///< legend, units, navigation, what views show
    Jobs,        ///< begun, ended or got further
    Log
};

enum class Severity { Note, Warning, Error };

struct LogEntry {
    Severity severity = Severity::Note;
    std::string text;
};

/// What the parts of a session share: the project as it is now, long work, the log, and who listens. One thread, but for
/// what jobs do.
class Workplace {
public:
    using Observer = std::function<void(Change)>;

    /// wake  called from any thread when jobs have something to deliver
    explicit Workplace(std::function<void()> wake) : jobs(std::move(wake)) {}

    /// Observers live as long as the workplace.
    void observe(Observer observer) { observers_.push_back(std::move(observer)); }
    void tell(Change change) const {
        for (const auto& observer : observers_) observer(change);
    }

    void note(std::string text) { enter({Severity::Note, std::move(text)}); }
    void warn(std::string text) { enter({Severity::Warning, std::move(text)}); }
    /// What went wrong, in the log; the window shows errors at once.
    void complain(const Error& error) { enter({Severity::Error, error.text()}); }
    /// The same as a job's last word; nothing of what was cancelled.
    [[nodiscard]] Jobs::Delivery complaint(const Error& error) {
        if (error.code == ErrorCode::Cancelled) return {};
        return [this, error] { complain(error); };
    }
    /// Writes in the background.
    ///
    /// title  while it runs
    /// done   for the log, when it went well; else what went wrong
    void save(std::string title, std::string done, std::function<Result<void>()> write) {
        jobs.start(JobKind::Save, std::move(title), [this, done = std::move(done), write = std::move(write)](const Progress&, const Jobs::Tell&) -> Jobs::Delivery {
            if (const auto written = write(); !written) return complaint(written.error());
            return [this, done] { note(done); };
        });
        tell(Change::Jobs);
    }
    [[nodiscard]] const std::vector<LogEntry>& log() const { return log_; }

    /// The project as it is now; null: none is open. Jobs keep the one that they began with.
    std::shared_ptr<const LitProject> project;
    Jobs jobs;

private:
    void enter(LogEntry entry) {
        log_.push_back(std::move(entry));
        tell(Change::Log);
    }

    std::vector<Observer> observers_;
    std::vector<LogEntry> log_;
};

}  // namespace luxdeck::gui
