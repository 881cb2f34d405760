#include "engine/core/parallel.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_scheduler_observer.h>

#include <sys/resource.h>
#include <unistd.h>

namespace luxdeck {

namespace {

/// More threads than cores are allowed (the determinism tests use 7 on any machine), so the arena is
/// made as wide as the limit says.
int g_arenaWidth = 0;

}  // namespace

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work) {
    if (count == 0) return;
    const auto loop = [&] {
        tbb::parallel_for(std::size_t{0}, count, work, tbb::simple_partitioner{});
    };
    if (g_arenaWidth > 0) {
        tbb::task_arena arena(g_arenaWidth);
        arena.execute(loop);
    } else {
        loop();
    }
}

ThreadLimit::ThreadLimit(int threads) : before_(g_arenaWidth) {
    g_arenaWidth = threads > 0 ? threads : 0;
    if (threads > 0)
        control_ = new tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                           static_cast<std::size_t>(threads));
}

ThreadLimit::~ThreadLimit() {
    delete static_cast<tbb::global_control*>(control_);
    g_arenaWidth = before_;
}

void yieldToOthers() {
    constexpr int kNiceness = 10;
    // On Linux niceness belongs to a thread. Refused, threads stay as they are.
    (void)setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness);
}

class YieldingWorkers::Observer : public tbb::task_scheduler_observer {
public:
    Observer() { observe(true); }
    ~Observer() override { observe(false); }
    Observer(const Observer&) = delete;
    Observer& operator=(const Observer&) = delete;

    void on_scheduler_entry(bool isWorker) override {
        if (isWorker) yieldToOthers();
    }
};

YieldingWorkers::YieldingWorkers() : observer_(std::make_unique<Observer>()) {}
YieldingWorkers::~YieldingWorkers() = default;

int threadCount() {
    return g_arenaWidth > 0 ? g_arenaWidth : tbb::this_task_arena::max_concurrency();
}

}  // namespace luxdeck
