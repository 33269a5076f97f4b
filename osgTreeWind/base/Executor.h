// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace osgTreeWind {

/// Runs job(0) to job(count - 1), in any order and several at once if it likes, and returns when all are
/// done. A host lends its own threads by handing over one of these, which several threads may call at once,
/// and jobs too. What is computed does not depend on it.
using Executor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

/// One job after another in the calling thread.
inline void runInTurn(std::size_t count, const std::function<void(std::size_t)>& job) {
    for (std::size_t i = 0; i < count; ++i)
        job(i);
}

} // namespace osgTreeWind
