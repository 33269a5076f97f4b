// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/canopy/AreaSums.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>

#include <vector>

namespace osgTreeWind {

/// Distributes the leaf area and drag area of a tree at rest over points. Their sums are those of
/// makeUnitLoads(). Leaf area and the drag of the crown lie on the leaf cards that are drawn, the drag of
/// bare wood along the wood.
class TreeAreas {
public:
    /// A point of a tree, metres from its foot, x east, y north.
    struct Point {
        glm::vec3 place{0.0f};
        AreaSums area;
    };

    /// @param step largest distance between points along a branch, metres.
    TreeAreas(const PlacedForest& forest, double step);

    /// The points of a tree with its current leaves. Valid until the next call.
    const std::vector<Point>& pointsOf(const PlacedTree& tree);
    /// The areas of a whole tree.
    AreaSums sumOf(const PlacedTree& tree) const;

private:
    /// A quarter of a quad of a leaf cluster.
    struct Card {
        glm::vec3 anchor, offset; ///< Anchor of the cluster; offset from the anchor.
        float size;               ///< Weight in the sum of all leaves, by the area of the cluster.
    };
    /// The cards of a shape.
    struct Cards {
        std::vector<Card> list;
        double size = 0.0; ///< Sum of all.
    };

    const Cards& cardsOf(const PlacedTree& tree);
    std::vector<UnitLoad> loadsOf(const PlacedTree& tree) const;
    void addWood(const PlacedTree& tree, const std::vector<UnitLoad>& loads);
    void addLeaves(const PlacedTree& tree, const AreaSums& leaves);

    const PlacedForest& _forest;
    double _step;
    std::vector<Cards> _cards; ///< By model; filled on first use.
    std::vector<Point> _points;
};

} // namespace osgTreeWind
