// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

class ShapeFamilies;

/// A crown as a circle around the foot of its tree, metres.
struct Crown {
    glm::dvec2 position{0.0};
    double height = 0.0; ///< Of the tree.
    double radius = 0.0;
};
/// The crown of a tree in a stand by the sizes that it or its species states, otherwise by usual ones.
Crown crownOf(const TreePlacement& tree, const Species& species);

/// Which values of a tree are derived from its neighbours because the file does not set them.
struct DerivedTreeValues {
    bool growingSpace = true; ///< TreePlacement::openGrown and atEdge.
    bool heading = true;      ///< If false, the tree is not rotated and never at an edge.
    bool seed = true;
};

/// Finds whether trees are open-grown, at the edge of a stand or in a stand, from the sectors around them
/// that have neighbours. A neighbour has at least 0.6 times the tree's height, and the gap between the crowns
/// is at most half the neighbour's height. A tree with neighbours on at least 3/4 of the sectors is in a
/// stand; on at most 1/4, it is open-grown, as are trees in a row. A tree at an edge is rotated to face its
/// open side. Affects only species that grow by light. @param derived by tree.
void findGrowingSpaces(ForestDescription& forest, const std::vector<DerivedTreeValues>& derived);

/// Increases seeds so that neighbours have different shapes, as far as there are enough shapes. Call it after
/// findGrowingSpaces(). Affects only species that grow by light. @param families of the forest.
void varyNeighbourSeeds(ForestDescription& forest, const ShapeFamilies& families,
                        const std::vector<DerivedTreeValues>& derived);

} // namespace osgTreeWind
