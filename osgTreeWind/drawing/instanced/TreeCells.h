// SPDX-License-Identifier: MIT
#pragma once

#include <osg/BoundingBox>
#include <osg/Vec3>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace osgTreeWind {

/// Trees by the ground they stand on: square cells that culling takes or leaves at once. Putting, moving and
/// taking a tree costs the same however many there are. Changed in update only.
class TreeCells {
public:
    /// A tree as culling sees it; metres, the forest's frame.
    struct Tree {
        osg::Vec3 foot;
        float height = 0.0f; ///< At rest.
        float reach = 0.0f;  ///< Of its crown from the foot, at rest.
        std::uint32_t number = 0;
    };
    struct Cell {
        std::vector<Tree> trees;
        osg::BoundingBox box; ///< Of all trees as far as they sway.
        bool stale = false;   ///< Whether the box may be too large, a tree having left.
    };
    static constexpr float side = 48.0f; ///< Of a cell, metres.

    /// How far a tree of this height is taken to sway, and which share of its height it may rise.
    static constexpr float sway = 0.35f, rise = 0.05f;
    static osg::BoundingBox boxOf(const Tree& tree);

    /// Puts a tree where it stands now, wherever it was; numbers are small.
    void put(const Tree& tree);
    void take(std::uint32_t number);

    /// Some may be empty.
    const std::vector<Cell>& cells() const { return _cells; }
    /// The tree of that number, which must be there.
    const Tree& tree(std::uint32_t number) const {
        return _cells[_places[number].cell].trees[_places[number].index];
    }
    /// All of them; boxes that were stale are made anew.
    osg::BoundingBox bounds();

private:
    struct Place {
        std::uint32_t cell = ~0u, index = 0;
    };
    std::uint32_t cellAt(const osg::Vec3& foot);

    std::vector<Cell> _cells;
    std::unordered_map<std::uint64_t, std::uint32_t> _byGround;
    std::vector<Place> _places; ///< By number.
};

} // namespace osgTreeWind
