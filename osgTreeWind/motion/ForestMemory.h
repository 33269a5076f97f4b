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

/// How much memory a forest's trees need and what memoryLimit() is; empty where they fit.
/// @param withNodes for a Forest, else for a ForestSimulation alone.
std::string problemOfMemory(const ForestDescription& description, bool withNodes);

} // namespace osgTreeWind
