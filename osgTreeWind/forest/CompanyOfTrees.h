// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <vector>

namespace osgTreeWind {

/// What is not said of a tree, and follows from those around it.
struct UnsaidCompany {
    bool company = true; ///< TreePlacement::openGrown and atEdge.
    bool heading = true; ///< To where it may be turned; else no tree is at an edge.
};

/// Finds in which company trees stand: a tree is at the edge of a wood, in it, or in the open, by the sides
/// on which there are neighbours. Those are trees of at least .6 of its height, of which the crowns are less
/// than a quarter of theirs away. With neighbours on three quarters of all sides it is in a wood; with none
/// on three quarters it is in the open, and so is one of a row. At an edge it is turned to its open side.
/// @param unsaid by tree.
void findCompany(ForestDescription& forest, const std::vector<UnsaidCompany>& unsaid);

} // namespace osgTreeWind
