// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ThreadPool.h>

#include <tests/EnvironmentVariable.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace osgTreeWind {
namespace {

/// The parameter is the number of threads.
class ThreadPools : public testing::TestWithParam<unsigned> {};

TEST_P(ThreadPools, RunEveryJobOnceInEveryRound) {
    ThreadPool pool(GetParam());
    for (std::size_t round = 0; round < 2000; ++round) {
        const std::size_t count = round % 37;
        std::vector<std::atomic<int>> done(count);
        pool.run(count, [&](std::size_t i) { ++done[i]; });
        for (std::size_t i = 0; i < count; ++i)
            ASSERT_EQ(done[i], 1) << "job " << i << " of " << count << " in round " << round;
    }
}

TEST_P(ThreadPools, HaveTheRequestedSize) {
    EXPECT_EQ(ThreadPool(GetParam()).threadCount(), GetParam());
}

TEST_P(ThreadPools, ReturnAfterAllJobsAreDone) {
    ThreadPool pool(GetParam());
    for (int round = 0; round < 20; ++round) {
        std::vector<int> plain(64, 0); // not atomic: a late job would be a data race
        pool.run(plain.size(), [&](std::size_t i) {
            if (i % 16 == 0)
                std::this_thread::sleep_for(std::chrono::microseconds(200));
            plain[i] = static_cast<int>(i) + 1;
        });
        for (std::size_t i = 0; i < plain.size(); ++i)
            ASSERT_EQ(plain[i], static_cast<int>(i) + 1) << "round " << round;
    }
}

TEST_P(ThreadPools, AcceptZeroJobs) {
    ThreadPool pool(GetParam());
    pool.run(0, [](std::size_t) { FAIL() << "there is no job"; });
}

TEST_P(ThreadPools, AreOwnedByTheirExecutor) {
    Executor executor = ThreadPool::executor(GetParam());
    const Executor copy = executor;
    executor = nullptr;
    std::atomic<int> done{0};
    copy(100, [&](std::size_t) { ++done; });
    EXPECT_EQ(done, 100);
}

TEST_P(ThreadPools, ServeConcurrentCallers) {
    ThreadPool pool(GetParam());
    std::vector<std::thread> callers;
    std::atomic<int> wrong{0};
    for (std::size_t caller = 0; caller < 4; ++caller)
        callers.emplace_back([&, caller] {
            for (std::size_t round = 0; round < 500; ++round) {
                std::vector<std::size_t> plain(1 + (7 * caller + round) % 23, 0);
                pool.run(plain.size(), [&](std::size_t i) { plain[i] += caller + round + i; });
                for (std::size_t i = 0; i < plain.size(); ++i)
                    wrong += plain[i] != caller + round + i;
            }
        });
    for (std::thread& caller : callers)
        caller.join();
    EXPECT_EQ(wrong, 0);
}

TEST_P(ThreadPools, AllowNestedCalls) {
    ThreadPool pool(GetParam());
    std::atomic<int> done{0};
    pool.run(6, [&](std::size_t) {
        pool.run(5, [&](std::size_t) { pool.run(4, [&](std::size_t) { ++done; }); });
    });
    EXPECT_EQ(done, 6 * 5 * 4);
}

TEST_P(ThreadPools, DoNotMakeACallerWaitForJobsOfAnother) {
    ThreadPool pool(GetParam());
    std::atomic<bool> begun{false}, end{false};
    std::thread slow([&] {
        pool.run(64, [&](std::size_t) {
            begun = true;
            while (!end)
                std::this_thread::yield();
        });
    });
    while (!begun)
        std::this_thread::yield();
    std::atomic<int> done{0};
    for (int round = 0; round < 100; ++round)
        pool.run(16, [&](std::size_t) { ++done; });
    end = true;
    slow.join();
    EXPECT_EQ(done, 1600);
}

INSTANTIATE_TEST_SUITE_P(, ThreadPools, testing::Values(1u, 2u, 3u, 4u),
                         [](const auto& info) { return std::to_string(info.param) + "Threads"; });

TEST(ThreadPool, RunsInTheCallingThreadIfItHasOneThread) {
    ThreadPool pool(1);
    std::set<std::thread::id> seen;
    pool.run(10, [&](std::size_t) { seen.insert(std::this_thread::get_id()); });
    EXPECT_EQ(seen, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(ThreadPool, ReadsTheThreadCountFromTheEnvironment) {
    const EnvironmentVariable three("OSGTREEWIND_THREADS", "3");
    EXPECT_EQ(ThreadPool().threadCount(), 3u);
    EXPECT_EQ(ThreadPool(2).threadCount(), 2u) << "an explicit number has precedence";
}

TEST(ThreadPool, DefaultExecutorsShareOnePool) {
    const auto threads = [] {
        std::set<std::thread::id> seen;
        std::mutex mutex;
        ThreadPool::executor()(64, [&](std::size_t) {
            std::this_thread::sleep_for(std::chrono::microseconds(100));
            const std::lock_guard<std::mutex> lock(mutex);
            seen.insert(std::this_thread::get_id());
        });
        return seen;
    };
    std::set<std::thread::id> seen = threads();
    for (int i = 0; i < 10; ++i)
        seen.merge(threads());
    EXPECT_LE(seen.size(), ThreadPool().threadCount());
}

TEST(ThreadPool, IgnoresInvalidValuesInTheEnvironment) {
    for (const char* value : {"", "0", "-2", "many", "100000"}) {
        const EnvironmentVariable invalid("OSGTREEWIND_THREADS", value);
        const unsigned processors = std::thread::hardware_concurrency();
        EXPECT_EQ(ThreadPool().threadCount(), processors > 0 ? processors : 1) << '"' << value << '"';
    }
}

} // namespace
} // namespace osgTreeWind
