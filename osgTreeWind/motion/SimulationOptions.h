// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/motion/modal/ModalTree.h>

namespace osgTreeWind {

/// How a ForestSimulation works.
struct SimulationOptions {
    bool leaves = true; ///< Whether leaves flutter.
    /// Under `modal`, of the description's trees and of those added, until setLevel(): far ones take
    /// less memory (simulatedTreeBytes()), from the start.
    ModalLevel level = ModalLevel::Near;
    Executor executor;            ///< A host's threads; none: for a large forest a thread for each processor.
    std::function<void()> placed; ///< Called after each tree is placed, for a person who waits; may be empty.
};

} // namespace osgTreeWind
