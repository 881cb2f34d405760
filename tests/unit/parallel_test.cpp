#include "engine/core/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

namespace luxdeck {
namespace {

TEST(Parallel, DoesEveryItemOnceAtAnyNumberOfThreads) {
    for (const int threads : {0, 1, 2, 7}) {
        const ThreadLimit limit(threads);
        for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
            std::vector<int> done(count, 0);
            parallelFor(count, [&](std::size_t i) { ++done[i]; });
            EXPECT_EQ(std::count(done.begin(), done.end(), 1), static_cast<std::ptrdiff_t>(count)) << threads << " threads";
        }
    }
}

TEST(Parallel, NeverUsesMoreThreadsThanAllowed) {
    for (const int threads : {1, 2, 3}) {
        const ThreadLimit limit(threads);
        std::atomic<int> now{0}, most{0};
        parallelFor(2000, [&](std::size_t) {
            const int here = ++now;
            for (int seen = most; seen < here && !most.compare_exchange_weak(seen, here);) {}
            --now;
        });
        EXPECT_LE(most, threads);
        EXPECT_EQ(threadCount(), threads);
    }
}

TEST(Parallel, LimitsEndWithTheirScope) {
    const int free = threadCount();
    {
        const ThreadLimit outer(3);
        {
            const ThreadLimit inner(1);
            EXPECT_EQ(threadCount(), 1);
        }
        EXPECT_EQ(threadCount(), 3);
    }
    EXPECT_EQ(threadCount(), free);
}

TEST(Parallel, LoopsMayNest) {
    const ThreadLimit limit(2);
    std::vector<int> done(100, 0);
    parallelFor(10, [&](std::size_t i) { parallelFor(10, [&](std::size_t j) { ++done[10 * i + j]; }); });
    EXPECT_EQ(std::count(done.begin(), done.end(), 1), 100);
}

TEST(Parallel, ExceptionsReachTheCaller) {
    const auto work = [](std::size_t i) {
        if (i == 57) throw std::runtime_error("57");
    };
    EXPECT_THROW(parallelFor(100, work), std::runtime_error);
}

}  // namespace
}  // namespace luxdeck
