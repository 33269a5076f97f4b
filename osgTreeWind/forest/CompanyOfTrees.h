// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <vector>

namespace osgTreeWind {

/// What a file does not say of a tree, and follows from those around it.
struct UnsaidOfTree {
    bool company = true; ///< TreePlacement::openGrown and atEdge.
    bool heading = true; ///< Else it is not turned, and not at an edge.
    bool seed = true;    ///< Which may be another by a few.
};

/// Finds in which company trees stand: a tree is at the edge of a wood, in it, or in the open, by the sides
/// on which there are neighbours. Those are trees of at least .6 of its height, of which the crowns are less
/// than half of theirs away. With neighbours on three quarters of all sides it is in a wood; with none
/// on three quarters it is in the open, and so is one of a row. At an edge it is turned to its open side.
/// @param unsaid by tree.
void findCompany(ForestDescription& forest, const std::vector<UnsaidOfTree>& unsaid);

/// Picks seeds by which neighbours do not share a shape, as far as there are shapes enough. As above, of
/// trees that grow by light, which have their company.
void tellApart(ForestDescription& forest, const std::vector<UnsaidOfTree>& unsaid);

} // namespace osgTreeWind
