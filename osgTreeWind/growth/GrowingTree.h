// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/growth/ShadeGrid.h>
#include <osgTreeWind/growth/TreeState.h>

#include <glm/vec3.hpp>

#include <cstdint>

namespace osgTreeWind {

/// A tree that grows year by year, in light that it may share with others.
class GrowingTree {
public:
    /// @param habit within its ranges. @param spread factor on side shoots, near 1.
    GrowingTree(const TreeHabit& habit, const GrowthGoal& goal, const glm::vec3& foot, std::uint32_t seed,
                float spread = 1.0f);

    /// Puts out this year's leaves, extends `lowest` and `highest` to hold them.
    void unfold(glm::vec3& lowest, glm::vec3& highest);
    void addLeaves(ShadeGrid& grid) const;
    /// Sheds, grows and sinks by the light of its leaves, which are in the grid.
    void growYear(const ShadeGrid& grid);

    const glm::vec3& foot() const { return _foot; }
    float height() const { return _state.height; }
    /// It has its height, or cannot get any higher.
    bool grown() const;
    const TreeState& state() const { return _state; }

private:
    void lookAround(const ShadeGrid& grid);
    void measure();

    TreeState _state;
    glm::vec3 _foot;
    float _landmark = 0.0f; ///< Height at which it was last seen to rise,
    int _risen = 0;         ///< in this year.
    int _matureFrom = 0;    ///< Year in which it had its height.
};

/// Mean reach of the living nodes in eight directions, metres.
float meanReach(const std::vector<Metamer>& metamers);

} // namespace osgTreeWind
