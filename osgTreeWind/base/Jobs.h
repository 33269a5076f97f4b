// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>

#include <algorithm>

namespace osgTreeWind {

/// Runs jobs on an executor, which sees no exceptions. After a job throws, no further jobs start; the first
/// exception is rethrown once the running jobs have finished.
void runJobs(const Executor& executor, std::size_t count, const std::function<void(std::size_t)>& job);

/// Calls work(0) to work(count - 1), 256 calls to a job, which saves overhead when each call is short.
template <typename Work>
void runInBatches(const Executor& executor, std::size_t count, const Work& work) {
    constexpr std::size_t batch = 256;
    runJobs(executor, (count + batch - 1) / batch, [&](std::size_t job) {
        for (std::size_t i = job * batch; i < std::min(count, (job + 1) * batch); ++i)
            work(i);
    });
}

} // namespace osgTreeWind
