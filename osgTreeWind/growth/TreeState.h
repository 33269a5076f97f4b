// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/growth/GrowthGoal.h>
#include <osgTreeWind/growth/TreeHabit.h>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// A piece of shoot and the node at its end, while the tree grows.
struct Metamer {
    glm::vec3 position{0.0f}; ///< Of the node, from the tree's foot.
    glm::vec3 heading{0.0f};  ///< From the parent's node; unit length.
    float length = 0.0f;
    int parent = -1, axis = 0, order = 0;
    int born = 0;
    int died = -1; ///< -1: it lives.
    float leafArea = 0.0f, light = 1.0f;
    float mainGain = 0.0f, sideGain = 0.0f; ///< Of what it bears along its axis, and of side shoots.
    float share = 0.0f;                     ///< Of the tree's growth that comes through it.
    float tilt = 0.0f;                      ///< By which it has sunk this year.
};

/// A place where a shoot may grow.
struct Bud {
    int node = 0; ///< Index of the metamer that bears it.
    glm::vec3 heading{0.0f, 0.0f, 1.0f};
    bool terminal = false;
    int axis = 0;        ///< That it continues or begins.
    float weight = 1.0f; ///< Of its gain among others.
    float store = 0.0f;  ///< Length that has been allotted to it and not grown yet.
    int resting = 0;     ///< Years.
    bool spent = false;  ///< It has grown or died.
    float light = 1.0f, gain = 0.0f, share = 0.0f;
};

/// What metamers of one line have in common.
struct ShootAxis {
    int order = 0;
    int born = 0;
    bool leading = false;    ///< A limb into which the trunk has dissolved, or the trunk.
    float luck = 1.0f;       ///< Its vigour and its weight over those of others.
    float phase = 0.0f;      ///< Azimuth of the last side bud.
    int side = 1;            ///< Of the zigzag.
    glm::vec3 bending{0.0f}; ///< Random, slowly changing.
};

/// All of a growing tree.
struct TreeState {
    TreeHabit habit;
    GrowthGoal goal;
    float spread = 1.0f; ///< Factor on side shoots by which the crown gets its width.
    Random random{1};
    int year = 0;
    std::vector<Metamer> metamers; ///< Parents before children; the first is the foot.
    std::vector<Bud> buds;
    std::vector<ShootAxis> axes;
    bool mature = false;                         ///< It has its height, and fills its crown.
    glm::vec2 middle{0.0f};                      ///< Of the crown: where the trunk ends.
    float height = 0.0f;                         ///< Of the highest living node.
    float reach = 0.0f;                          ///< Mean of the living nodes' reach in eight directions.
    glm::vec2 leanAtFoot{0.0f}, leanAbove{0.0f}; ///< Of the stem, sideways for one upwards.
    float sideLight = 1.0f; ///< Around its crown: 1 in the open, little in a closed wood.

    ShootAxis& axisOf(const Bud& bud) { return axes[static_cast<std::size_t>(bud.axis)]; }
    const ShootAxis& axisOf(const Bud& bud) const { return axes[static_cast<std::size_t>(bud.axis)]; }
    const Metamer& metamerOf(const Bud& bud) const { return metamers[static_cast<std::size_t>(bud.node)]; }
    /// Place in a ByOrder.
    static std::size_t rank(int order) { return static_cast<std::size_t>(std::min(order, 3)); }
    /// Share of the final height that it has.
    float grown() const { return std::min(height / goal.height, 1.0f); }
    /// Where its stem rises to at a height: few stand straight.
    glm::vec3 upright(float z) const {
        const float share = std::min(z / goal.height, 1.0f), above = 1.0f - share;
        return glm::vec3(above * (leanAtFoot + 4.0f * share * leanAbove), 1.0f);
    }
    /// 0 in a closed wood, 1 in the open.
    float openness() const { return glm::smoothstep(0.6f, 0.95f, sideLight); }
    /// TreeHabit::lightNeed of its leaves: those of trees in a wood do with less.
    float lightNeed() const { return habit.lightNeed * glm::mix(0.5f, 1.0f, openness()); }
};

} // namespace osgTreeWind
