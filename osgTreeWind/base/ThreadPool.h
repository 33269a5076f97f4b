// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>

#include <memory>

namespace osgTreeWind {

/// A few threads that wait for work and share it with whoever brings it.
class ThreadPool {
public:
    /// @param threads in all, a caller's own counted; 0: as the environment's OSGTREEWIND_THREADS says,
    /// else one for each processor.
    explicit ThreadPool(unsigned threads = 0);
    /// Not while any thread is in run().
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    unsigned threadCount() const;

    /// As Executor. Any number of threads may call it at once, and so may jobs: a caller works on its own
    /// jobs only, and waits for none but those that another thread has begun. Jobs must not throw: runJobs()
    /// keeps their exceptions.
    void run(std::size_t count, const std::function<void(std::size_t)>& job);

    /// The pool of the process, which starts at the first call; it serves all forests that no host lends
    /// threads to. @param threads 0; else a pool of that many, which lives as long as the executor.
    static Executor executor(unsigned threads = 0);

private:
    struct Batch;
    struct State;
    std::unique_ptr<State> _state;
};

} // namespace osgTreeWind
