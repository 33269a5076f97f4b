// SPDX-License-Identifier: MIT
#pragma once

#include <osg/BoundingBox>
#include <osg/Vec3>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace osgTreeWind {

/// Sorts the trees of a forest into square cells of ground for culling. Inserting, moving and removing a tree
/// take constant time. Changed in update only.
class TreeCells {
public:
    /// Extents of a tree at rest; metres, the forest's frame.
    struct Tree {
        osg::Vec3 foot;
        float height = 0.0f;
        float reach = 0.0f; ///< Largest horizontal distance of the crown from the foot.
        std::uint32_t slot = 0;
    };
    struct Cell {
        std::vector<Tree> trees;
        osg::BoundingBox box; ///< Holds the swaying trees.
        bool stale = false;   ///< Whether the box may be too large since a tree was removed.
    };
    static constexpr float side = 48.0f; ///< Of a cell, metres.

    /// Assumed sway and rise of a tree, as shares of its height.
    static constexpr float sway = 0.35f, rise = 0.05f;
    /// A conservative bound of a swaying tree.
    static osg::BoundingBox swayBox(const Tree& tree);

    /// Adds a tree, or moves the one in this slot. Memory grows with the largest slot.
    void insert(const Tree& tree);
    void remove(std::uint32_t slot);

    /// May include empty cells.
    const std::vector<Cell>& cells() const { return _cells; }
    /// The tree in a slot, which must be occupied.
    const Tree& tree(std::uint32_t slot) const {
        return _cells[_places[slot].cell].trees[_places[slot].index];
    }
    /// Bounds of all swaying trees. Recomputes stale boxes.
    osg::BoundingBox bounds();

private:
    struct Place {
        std::uint32_t cell = ~0u, index = 0;
    };
    std::uint32_t cellAt(const osg::Vec3& foot);

    std::vector<Cell> _cells;
    std::unordered_map<std::uint64_t, std::uint32_t> _cellByPosition;
    std::vector<Place> _places; ///< By slot.
};

} // namespace osgTreeWind
