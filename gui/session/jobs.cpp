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
    bool abandoned = false;  // likewise
    std::thread thread;

    Job(std::uint64_t number, JobKind what, std::string name, Progress::Listener listener)
        : id(number), kind(what), title(std::move(name)), progress(std::move(listener)) {}
};

Jobs::Jobs(std::function<void()> wake) : wake_(std::move(wake)) {}

Jobs::~Jobs() {
    for (auto& job : jobs_) job->progress.cancel();
    for (auto& job : jobs_) job->thread.join();
}

void Jobs::say(Said said) {
    {
        const std::lock_guard lock(mutex_);
        said_.push_back(std::move(said));
    }
    if (wake_) wake_();
}

std::uint64_t Jobs::start(JobKind kind, std::string title, Work work) {
    const auto id = next_++;
    auto listener = [this, id](const ProgressState& state) {
        say({id, [this, id, state] { (*find(id))->state = state; }, false});
    };
    auto& job = *jobs_.emplace_back(std::make_unique<Job>(id, kind, std::move(title), std::move(listener)));
    job.thread = std::thread([this, &job, work = std::move(work)] {
        yieldToOthers();
        Delivery last = work(job.progress, [this, &job](Delivery delivery) { say({job.id, std::move(delivery), false}); });
        say({job.id, std::move(last), true});
    });
    return id;
}

std::list<std::unique_ptr<Jobs::Job>>::iterator Jobs::find(std::uint64_t id) {
    return std::find_if(jobs_.begin(), jobs_.end(), [&](const auto& job) { return job->id == id; });
}

void Jobs::cancel(std::uint64_t id) {
    if (const auto at = find(id); at != jobs_.end()) (*at)->progress.cancel();
}

void Jobs::cancel(JobKind kind) {
    for (auto& job : jobs_)
        if (job->kind == kind) job->progress.cancel();
}

void Jobs::cancelAll() {
    for (auto& job : jobs_) job->progress.cancel();
}

void Jobs::abandon(std::uint64_t id) {
    const auto at = find(id);
    if (at == jobs_.end()) return;
    (*at)->progress.cancel();
    (*at)->abandoned = true;
}

void Jobs::abandonAll() {
    for (auto& job : jobs_)
        if (job->kind != JobKind::Save) abandon(job->id);
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
    std::vector<Said> said;
    {
        const std::lock_guard lock(mutex_);
        said.swap(said_);
    }
    for (auto& [id, delivery, last] : said) {
        const auto at = find(id);
        if (at == jobs_.end()) continue;  // a delivery before this one has run an event loop, and the job has ended in it
        const bool wanted = !(*at)->abandoned;
        if (last) {
            (*at)->thread.join();
            jobs_.erase(at);
        }
        if (wanted && delivery) delivery();
    }
    return !said.empty();
}

}  // namespace luxdeck::gui
