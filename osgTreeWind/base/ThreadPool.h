// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>

#include <memory>

namespace osgTreeWind {

/// A few threads that wait for work and share it with the caller.
class ThreadPool {
public:
    /// @param threads in all, the caller's own counted; 0: as the environment's OSGTREEWIND_THREADS says,
    /// else one for each processor.
    explicit ThreadPool(unsigned threads = 0);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    unsigned threadCount() const;

    /// As Executor. One caller at a time; jobs must not call it again, nor throw.
    void run(std::size_t count, const std::function<void(std::size_t)>& job);

    /// A pool as an executor that keeps it alive.
    static Executor executor(unsigned threads = 0);

private:
    struct State;
    std::unique_ptr<State> _state;
};

} // namespace osgTreeWind
