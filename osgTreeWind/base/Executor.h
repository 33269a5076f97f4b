// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace osgTreeWind {

/// Runs job(0) to job(count - 1) in any order, possibly in parallel, and returns when all are done. A host
/// passes one to run the library's work on its own threads. It must allow calls from several threads and from
/// within jobs. Results do not depend on it.
using Executor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

/// An Executor that runs the jobs one after another in the calling thread.
inline void runInTurn(std::size_t count, const std::function<void(std::size_t)>& job) {
    for (std::size_t i = 0; i < count; ++i)
        job(i);
}

} // namespace osgTreeWind
