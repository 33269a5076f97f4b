// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ShapeFamilies.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/motion/modal/ModalTree.h>

#include <cstdint>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Estimated main memory of a forest, bytes; used to refuse a forest that would not fit.
struct MemoryEstimate {
    std::uint64_t simulation = 0; ///< ForestSimulation: shapes, parameters and states.
    /// Added by Forest: geometry and pose textures; under a branchwise law, a scene graph node per tree.
    std::uint64_t nodes = 0;
};

/// @param description must pass check().
MemoryEstimate estimateMemory(const ForestDescription& description);
/// The same. @param families of the forest. @param largest their countLargest().
MemoryEstimate estimateMemory(const ForestDescription& description, const ShapeFamilies& families,
                              const std::vector<TreeCounts>& largest);

/// Vertices and indices of a tree's bark and leaves at full detail, under a branchwise law.
std::uint64_t geometryBytes(const TreeCounts& counts);
/// Vertices, indices and leaf records of a tree at all tiers under `modal`; at most, for bark and indices.
std::uint64_t meshBytes(const TreeCounts& counts);

/// Simulation memory per tree under `modal`: 262 bytes far, 421 near.
std::size_t simulatedTreeBytes(ModalLevel level);

/// States the memory that a forest needs and memoryLimit(); empty if the forest fits.
/// @param description must pass check(). @param withNodes for a Forest; otherwise for a ForestSimulation.
std::string problemOfMemory(const ForestDescription& description, bool withNodes);
/// The same for a ForestSimulation. @param families, largest as for estimateMemory().
std::string problemOfMemory(const ForestDescription& description, const ShapeFamilies& families,
                            const std::vector<TreeCounts>& largest);

} // namespace osgTreeWind
