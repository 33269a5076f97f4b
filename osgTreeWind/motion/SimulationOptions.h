// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>

#include <functional>

namespace osgTreeWind {

/// How a ForestSimulation works.
struct SimulationOptions {
    bool leaves = true; ///< Whether leaves flutter.
    /// Under `modal`: trees are far from any viewer. They sway in up to 4 modes, with a step each fifth of a
    /// second, and take less memory.
    bool distant = false;
    /// A host's threads, for copies (restarted()) too, which other threads may advance; none: those of the
    /// process for a large forest, the calling thread for a small one.
    Executor executor;
    std::function<void()> placed; ///< Called after each tree is placed, for a person who waits; may be empty.
};

} // namespace osgTreeWind
