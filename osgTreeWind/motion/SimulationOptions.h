// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>

#include <functional>

namespace osgTreeWind {

/// Options of a ForestSimulation.
struct SimulationOptions {
    bool leaves = true; ///< Whether leaves flutter.
    /// Under `modal`: for trees far from any viewer. They take less memory, with up to 4 modes and 5 steps a
    /// second.
    bool distant = false;
    /// Threads of the host, also for copies (cloneAtRest()), which other threads may advance. Null: the
    /// process's thread pool for a large forest, the calling thread for a small one.
    Executor executor;
    /// Called after each tree is placed, to report progress; may be empty.
    std::function<void()> onTreePlaced;
};

} // namespace osgTreeWind
