// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrowingTree.h>
#include <osgTreeWind/growth/GrowthSite.h>

#include <vector>

namespace osgTreeWind {

/// Edge of the boxes in which the light of trees of a habit is reckoned, metres.
float lightCell(const TreeHabit& habit);

/// Trees that grow together and take each other's light.
class GrowingStand {
public:
    /// @param cell edge of the boxes in which light is reckoned, metres: about an internode.
    explicit GrowingStand(float cell) : _grid(cell) {}

    void add(GrowingTree tree) { _trees.push_back(std::move(tree)); }
    void remove(std::size_t tree) { _trees.erase(_trees.begin() + static_cast<std::ptrdiff_t>(tree)); }
    const std::vector<GrowingTree>& trees() const { return _trees; }

    /// One year of all trees. @param site neighbours beyond those that grow here, around the first.
    void growYear(const GrowthSite& site = {});

private:
    ShadeGrid _grid;
    std::vector<GrowingTree> _trees;
};

} // namespace osgTreeWind
