#include "gui/session/jobs.h"

#include "engine/core/parallel.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace luxdeck::gui {

struct Jobs::Job {
    std::uint64_t id;
    JobKind kind;
    std::string title;
    Stopwatch clock;
    ProgressState state;  // the owner's thread alone
    Progress progress;
    std::thread thread;

    Job(std::uint64_t number, JobKind what, std::string name, Progress::Listener listener)
        : id(number), kind(what), title(std::move(name)), progress(std::move(listener)) {}
};

Jobs::Jobs(std::function<void()> wake) : wake_(std::move(wake)) {}

Jobs::~Jobs() {
    cancelAll();
    for (auto& job : jobs_) job->thread.join();
}

void Jobs::say(Delivery delivery) {
    {
        const std::lock_guard lock(mutex_);
        said_.push_back(std::move(delivery));
    }
    if (wake_) wake_();
}

std::uint64_t Jobs::start(JobKind kind, std::string title, Work work) {
    const auto id = next_++;
    auto listener = [this, id](const ProgressState& state) {
        say([this, id, state] {
            for (auto& job : jobs_)
                if (job->id == id) job->state = state;
        });
    };
    auto& job = *jobs_.emplace_back(std::make_unique<Job>(id, kind, std::move(title), std::move(listener)));
    job.thread = std::thread([this, &job, work = std::move(work)] {
        yieldToOthers();
        Delivery last = work(job.progress, [this](Delivery delivery) { say(std::move(delivery)); });
        say([this, id = job.id, last = std::move(last)] {
            const auto at = std::find_if(jobs_.begin(), jobs_.end(), [&](const auto& j) { return j->id == id; });
            (*at)->thread.join();
            jobs_.erase(at);
            if (last) last();
        });
    });
    return id;
}

void Jobs::cancel(std::uint64_t id) {
    for (auto& job : jobs_)
        if (job->id == id) job->progress.cancel();
}

void Jobs::cancel(JobKind kind) {
    for (auto& job : jobs_)
        if (job->kind == kind) job->progress.cancel();
}

void Jobs::cancelAll() {
    for (auto& job : jobs_) job->progress.cancel();
}

bool Jobs::running(JobKind kind) const {
    return std::any_of(jobs_.begin(), jobs_.end(), [&](const auto& job) { return job->kind == kind; });
}

std::vector<JobState> Jobs::states() const {
    std::vector<JobState> states;
    for (const auto& job : jobs_) states.push_back({job->id, job->kind, job->title, job->state, job->clock.seconds(), job->progress.cancelled()});
    return states;
}

bool Jobs::deliver() {
    std::vector<Delivery> said;
    {
        const std::lock_guard lock(mutex_);
        said.swap(said_);
    }
    for (auto& delivery : said) delivery();
    return !said.empty();
}

}  // namespace luxdeck::gui
