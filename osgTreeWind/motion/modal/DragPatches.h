// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/JointTree.h>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Parts a tree into patches on which one wind acts: bough by bough, each cut where it takes most away from
/// the spread of drag within patches. A patch is a link with all it carries, less what was cut from it.
/// @param count the most there are to be, at least 1.
/// @return the patch of each link; the first `n` patches of a larger count are cut as for `n`.
std::vector<std::size_t> dragPatches(const JointTree& tree, std::size_t count);

} // namespace osgTreeWind
