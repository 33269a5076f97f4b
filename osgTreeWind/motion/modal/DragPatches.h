// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/JointTree.h>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Divides a tree into patches, each exposed to one wind. Each cut separates a bough where that reduces the
/// spread of drag within patches most. A patch is a link with its descendants, less later cuts.
/// @param count maximum number of patches, at least 1.
/// @return the patch of each link. The first `n` patches of a larger count are cut as for `n`.
std::vector<std::size_t> dragPatches(const JointTree& tree, std::size_t count);

} // namespace osgTreeWind
