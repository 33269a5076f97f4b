// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrowYear.h>
#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/growth/GrowthParameters.h>

namespace osgTreeWind {

/// A tree that grows year by year, in a light grid that it may share with other trees.
class GrowingTree {
public:
    /// @param habit must be within its ranges. @param spread factor on the vigour of boughs, near 1.
    GrowingTree(const TreeHabit& habit, const GrowthGoal& goal, const glm::vec3& foot, std::uint32_t seed,
                float spread = 1.0f);

    /// Sets this year's leaf areas and extends the bounds `lowest` and `highest` by the tree's nodes.
    void unfoldLeaves(glm::vec3& lowest, glm::vec3& highest);
    void addLeaves(ShadeGrid& grid) const;
    /// Grows by a year according to the light in `grid`, which must contain the leaves of this tree.
    void grow(const ShadeGrid& grid);

    const glm::vec3& foot() const { return _foot; }
    float height() const { return _state.height; }
    /// Whether the tree has filled its crown at its final height, or cannot grow any higher.
    bool isFullyGrown() const;
    const TreeState& state() const { return _state; }

private:
    void measureSideLight(const ShadeGrid& grid);
    void measureCrown();

    TreeState _state;
    glm::vec3 _foot;
    float _lastRiseHeight = 0.0f; ///< Height at the last notable increase.
    int _lastRiseYear = 0;        ///< Year of that increase.
    int _matureYear = 0;          ///< Year in which the tree reached its height.
};

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

/// Grows a tree from a seedling to its goal, by self-organisation (Palubicki et al. 2009).
///
/// Each year leaves unfold and shade each other (ShadeGrid), branches without enough light die, the growth
/// that the light allows is distributed among buds, shoots grow and get new side buds, and boughs sink
/// (growYear()). The tree grows until it reaches its height. Up to six growths search the vigour of boughs
/// that gives the crown its width. The remaining difference is stretched (GrownForm::heightFactor,
/// widthFactor); these factors differ much if the site leaves too little light for such a crown.
///
/// Values out of range are clamped. One seed gives one tree, bit for bit, on every machine. Thread-safe.
GrownForm growTree(const GrowthParameters& parameters);

} // namespace osgTreeWind
