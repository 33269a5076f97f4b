// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrowingTree.h>
#include <osgTreeWind/growth/GrowthSite.h>

#include <vector>

namespace osgTreeWind {

/// Cell size of a GrowingStand that suits trees of a habit, metres: about two internodes.
float lightCellSize(const TreeHabit& habit);

/// Trees that grow together and shade each other.
class GrowingStand {
public:
    /// @param cellSize cell edge of the light grid, metres.
    explicit GrowingStand(float cellSize) : _grid(cellSize) {}

    void add(GrowingTree tree) { _trees.push_back(std::move(tree)); }
    void remove(std::size_t tree) { _trees.erase(_trees.begin() + static_cast<std::ptrdiff_t>(tree)); }
    const std::vector<GrowingTree>& trees() const { return _trees; }

    /// Grows all trees by one year. @param site neighbours around the first tree that do not grow here.
    void growYear(const GrowthSite& site = {});

private:
    ShadeGrid _grid;
    std::vector<GrowingTree> _trees;
};

} // namespace osgTreeWind
