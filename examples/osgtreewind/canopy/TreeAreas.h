// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/canopy/AreaSums.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>

#include <vector>

namespace osgTreeWind {

/// Where a tree has its leaves and its drag, at rest: points with an area each, which add up to what
/// makeUnitLoads() says of the tree. Leaves and the drag of the crown lie over the cards that are drawn, that
/// of bare wood along it.
class TreeAreas {
public:
    /// A point of a tree: metres from its foot, x east, y north.
    struct Point {
        glm::vec3 place{0.0f};
        AreaSums area;
    };

    /// @param step the farthest that points of a branch are to be apart, metres.
    TreeAreas(const PlacedForest& forest, double step);

    /// Of a tree of the forest, as many leaves as it bears now. Holds until the next call.
    const std::vector<Point>& of(const PlacedTree& tree);
    /// All of it together.
    AreaSums sumOf(const PlacedTree& tree) const;

private:
    /// A quarter of a quad of a cluster of leaves.
    struct Card {
        glm::vec3 anchor, offset; ///< Of the cluster; from there.
        float size;               ///< What it has of the leaves, by the area of its cluster.
    };
    /// Of a shape.
    struct Cards {
        std::vector<Card> list;
        double size = 0.0; ///< Of all.
    };

    const Cards& cardsOf(const PlacedTree& tree);
    std::vector<UnitLoad> loadsOf(const PlacedTree& tree) const;
    void addWood(const PlacedTree& tree, const std::vector<UnitLoad>& loads);
    void addLeaves(const PlacedTree& tree, const AreaSums& leaves);

    const PlacedForest& _forest;
    double _step;
    std::vector<Cards> _cards; ///< By model; empty until a tree asks.
    std::vector<Point> _points;
};

} // namespace osgTreeWind
