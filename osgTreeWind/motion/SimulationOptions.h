// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/motion/modal/ModalLevel.h>

#include <memory>

namespace osgTreeWind {

class GivenWind;

/// How a ForestSimulation works.
struct SimulationOptions {
    bool leaves = true; ///< Whether leaves flutter.
    /// Under `modal`, of the description's trees and of those added, until setLevel(): far ones take
    /// less memory (simulatedTreeBytes()), from the start.
    ModalLevel level = ModalLevel::Near;
    /// A host's threads, for copies (restarted()) too, which other threads may advance; none: those of the
    /// process (ThreadPool::executor()) for a large forest, the calling thread for a small one.
    Executor executor;
    /// Where the wind is given from now on; null: a place of its own, with the description's.
    std::shared_ptr<GivenWind> wind;
    std::function<void()> placed; ///< Called after each tree is placed, for a person who waits; may be empty.
};

} // namespace osgTreeWind
