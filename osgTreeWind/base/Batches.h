// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>

#include <algorithm>

namespace osgTreeWind {

/// Runs jobs on an executor. The first exception of a job is thrown once all that have begun are done; those
/// that have not are left out, and no thread of the executor meets it.
void runJobs(const Executor& executor, std::size_t count, const std::function<void(std::size_t)>& job);

/// Calls work(0) to work(count - 1) in batches, each one job of the executor: for work that is short.
template <typename Work>
void runInBatches(const Executor& executor, std::size_t count, const Work& work) {
    constexpr std::size_t batch = 256;
    runJobs(executor, (count + batch - 1) / batch, [&](std::size_t job) {
        for (std::size_t i = job * batch; i < std::min(count, (job + 1) * batch); ++i)
            work(i);
    });
}

} // namespace osgTreeWind
