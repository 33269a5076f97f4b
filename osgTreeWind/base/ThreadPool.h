// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>

#include <memory>

namespace osgTreeWind {

/// A pool of worker threads that help calling threads run their jobs.
class ThreadPool {
public:
    /// @param threads including the calling one; 0: the value of the environment variable
    /// OSGTREEWIND_THREADS, or else one per processor.
    explicit ThreadPool(unsigned threads = 0);
    /// Must not be called while a thread is in run().
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    unsigned threadCount() const;

    /// Runs jobs as an Executor does. Thread-safe, and jobs may call it. A caller runs its own jobs only, and
    /// waits only for those that workers have started. Jobs must not throw; runJobs() handles exceptions.
    void run(std::size_t count, const std::function<void(std::size_t)>& job);

    /// An executor that runs jobs on a pool.
    /// @param threads 0: the pool of the process, started at the first call, for all forests without an
    /// executor of the host. Otherwise a new pool of that size, owned by the executor.
    static Executor executor(unsigned threads = 0);

private:
    struct Batch;
    struct State;
    std::unique_ptr<State> _state;
};

} // namespace osgTreeWind
