// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/growth/ShadeGrid.h>
#include <osgTreeWind/growth/TreeState.h>

#include <glm/vec3.hpp>

#include <cstdint>

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
    /// Sheds branches, grows shoots and sinks boughs according to the light in `grid`, which must contain the
    /// leaves of this tree.
    void growYear(const ShadeGrid& grid);

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

/// Mean horizontal reach of the living nodes in eight directions, metres.
float meanCrownRadius(const std::vector<Metamer>& metamers);

} // namespace osgTreeWind
