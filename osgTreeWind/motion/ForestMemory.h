// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/motion/modal/ModalTree.h>

#include <cstdint>
#include <string>

namespace osgTreeWind {

/// Bytes of main memory that a forest is going to need, near enough to say no before it is asked for.
struct ForestMemory {
    std::uint64_t simulation = 0; ///< Shapes, parameters and states: ForestSimulation.
    std::uint64_t nodes =
        0; ///< What Forest adds: geometry, textures of poses; under a law of a branch a node a tree.
};
/// @param description for which check() finds nothing, as below.
ForestMemory forestMemory(const ForestDescription& description);

/// Of that, the vertices and indices of a tree's bark and leaves as they are drawn in full.
std::uint64_t geometryBytes(const TreeCounts& counts);

/// Of that, what each tree adds to a simulation under `modal`: 262 bytes far, 421 near.
std::size_t simulatedTreeBytes(ModalLevel level);

/// What may be asked for: the environment's OSGTREEWIND_MAX_MEMORY, bytes or a number with k, M, G or T, else
/// what the machine has available now and the process may have (ulimit -v). The largest number where neither
/// is known.
std::uint64_t memoryLimit();

/// How much `what` need and what the limit is; empty where it fits. @param what several of them.
std::string problemOfMemory(const std::string& what, std::uint64_t bytes);

/// The same of a forest's trees. @param withNodes for a Forest, else for a
/// ForestSimulation alone.
std::string problemOfMemory(const ForestDescription& description, bool withNodes);

} // namespace osgTreeWind
