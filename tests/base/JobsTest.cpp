// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Guarded.h>
#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/base/ThreadPool.h>

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace osgTreeWind {
namespace {

TEST(RunJobs, RethrowsTheFirstExceptionAfterRunningJobsFinish) {
    const Executor threads = ThreadPool::executor(4);
    for (int round = 0; round < 100; ++round) {
        std::atomic<int> running{0};
        std::vector<int> done(50, 0); // not atomic: a late job would be a data race
        const auto job = [&](std::size_t i) {
            ++running;
            done[i] = 1;
            --running;
            if (i == 20)
                throw std::runtime_error("job 20");
        };
        EXPECT_THROW(runJobs(threads, done.size(), job), std::runtime_error);
        EXPECT_EQ(running, 0);
        EXPECT_EQ(done[20], 1);
    }
}

TEST(RunJobs, RunsEveryJobOnce) {
    std::vector<int> done(50, 0);
    runJobs(ThreadPool::executor(4), done.size(), [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(50, 1));
}

TEST(RunGuarded, ReturnsTheMessageOfTheException) {
    EXPECT_EQ(runGuarded([] {}), "");
    EXPECT_EQ(runGuarded([] { throw std::runtime_error("no such thing"); }), "no such thing");
    EXPECT_EQ(runGuarded([] { throw std::bad_alloc(); }), "out of memory");
    EXPECT_EQ(runGuarded([] { throw 5; }), "unknown error");
}

TEST(GuardedResult, ReturnsTheResultOrTheException) {
    EXPECT_EQ(guardedResult([] { return Result<int>(5); }).value(), 5);
    const auto failed = guardedResult([]() -> Result<int> { throw std::bad_alloc(); });
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.problems().front().message, "out of memory");
    EXPECT_EQ(guardedResult([]() -> Diagnostics { throw std::bad_alloc(); }).size(), 1u);
}

} // namespace
} // namespace osgTreeWind
