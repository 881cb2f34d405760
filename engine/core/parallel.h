#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace luxdeck {

/// Runs work(i) for i in 0 .. count-1 on oneTBB. Each i must write only its own outputs; whoever merges
/// them does so in index order, so that results do not depend on the number of threads.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work);

/// Limits the threads of everything that follows, until destroyed; then the limit before holds again. 0 = all cores.
class ThreadLimit {
public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    void* control_ = nullptr;  // tbb::global_control, kept out of this header
    int before_ = 0;           // threads of the limit that this one is within
};

/// While it lives, threads that help others (not those that call parallelFor) yield to everything else on the machine, so
/// that a window stays quick while its room is being lit. Where the system refuses, nothing happens.
class YieldingWorkers {
public:
    YieldingWorkers();
    ~YieldingWorkers();
    YieldingWorkers(const YieldingWorkers&) = delete;
    YieldingWorkers& operator=(const YieldingWorkers&) = delete;

private:
    class Observer;
    std::unique_ptr<Observer> observer_;
};

/// Makes the calling thread, and those it starts, yield likewise.
void yieldToOthers();

/// Threads that parallelFor uses now.
int threadCount();

}  // namespace luxdeck
