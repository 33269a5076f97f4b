// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/growth/GrowthGoal.h>
#include <osgTreeWind/growth/ShadeGrid.h>
#include <osgTreeWind/growth/TreeHabit.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// A shoot segment and the node at its end, while the tree grows.
struct Metamer {
    glm::vec3 position{0.0f}; ///< Position of the node, from the tree's foot.
    glm::vec3 heading{0.0f};  ///< From the parent's node; unit length.
    float length = 0.0f;
    int parent = -1, axis = 0, order = 0;
    int born = 0;
    int died = -1; ///< Year of death; -1 if it lives.
    float leafArea = 0.0f, light = 1.0f;
    float mainGain = 0.0f, sideGain = 0.0f; ///< Gains of the rest of its axis, and of its side shoots.
    float share = 0.0f;                     ///< Share of the tree's growth that passes through it.
    float tilt = 0.0f;                      ///< Angle by which it sank this year.
};

/// A place where a shoot may grow.
struct Bud {
    int node = 0; ///< Index of the metamer that bears it.
    glm::vec3 heading{0.0f, 0.0f, 1.0f};
    bool terminal = false;
    int axis = 0;              ///< Axis that it continues or begins.
    float weight = 1.0f;       ///< Weight of its gain among the other buds.
    float storedLength = 0.0f; ///< Allotted length that has not grown yet.
    int restingYears = 0;      ///< Years.
    bool spent = false;        ///< Whether it has grown or died.
    float light = 1.0f, gain = 0.0f, share = 0.0f;
};

/// A line of metamers that continue each other.
struct ShootAxis {
    int order = 0;
    int born = 0;
    bool leading = false;      ///< Whether it is the trunk or a limb that continues it.
    float vigourFactor = 1.0f; ///< Random factor on its vigour and sinking.
    float phase = 0.0f;        ///< Azimuth of the last side bud.
    int zigzagSign = 1;        ///< Side of the next zigzag bend.
    glm::vec3 bend{0.0f};      ///< Random bend, slowly changing.
};

/// State of a growing tree.
struct TreeState {
    TreeHabit habit;
    GrowthGoal goal;
    float spread = 1.0f; ///< Factor on the vigour of boughs.
    Random random{1};
    int year = 0;
    std::vector<Metamer> metamers; ///< The first is the foot; parents precede their children.
    std::vector<Bud> buds;
    std::vector<ShootAxis> axes;
    bool mature = false;                         ///< Whether it has its height and only fills its crown.
    glm::vec2 crownCentre{0.0f};                 ///< Place of the trunk's top.
    float height = 0.0f;                         ///< Height of the highest living node.
    float crownRadius = 0.0f;                    ///< Mean reach of the living nodes in eight directions.
    glm::vec2 leanAtFoot{0.0f}, leanAbove{0.0f}; ///< Lean of the stem, sideways per metre up.
    float sideLight = 1.0f; ///< Light around its crown: 1 in the open, low in a closed stand.

    ShootAxis& axisOf(const Bud& bud) { return axes[static_cast<std::size_t>(bud.axis)]; }
    const ShootAxis& axisOf(const Bud& bud) const { return axes[static_cast<std::size_t>(bud.axis)]; }
    const ShootAxis& axisOf(const Metamer& part) const { return axes[static_cast<std::size_t>(part.axis)]; }
    Metamer& metamerOf(const Bud& bud) { return metamers[static_cast<std::size_t>(bud.node)]; }
    Metamer& parentOf(const Metamer& part) { return metamers[static_cast<std::size_t>(part.parent)]; }
    /// Index into a ByOrder.
    static std::size_t rank(int order) { return static_cast<std::size_t>(std::min(order, 3)); }
    /// Height / goal height, at most 1.
    float relativeHeight() const { return std::min(height / goal.height, 1.0f); }
    /// Direction in which the stem grows at a height: stems lean a little. Not normalized.
    glm::vec3 stemDirection(float z) const {
        const float share = std::min(z / goal.height, 1.0f), above = 1.0f - share;
        return glm::vec3(above * (leanAtFoot + 4.0f * share * leanAbove), 1.0f);
    }
    /// Openness of the site: 0 in a closed stand, 1 in the open.
    float openness() const { return glm::smoothstep(0.6f, 0.95f, sideLight); }
    /// TreeHabit::lightNeed, reduced for the shade leaves of trees in a stand.
    float lightNeed() const { return habit.lightNeed * glm::mix(0.5f, 1.0f, openness()); }
};

/// Grows a tree by a year, with the leaves and the light that its metamers and buds have: sheds branches,
/// allots the growth to buds, grows shoots, and sinks boughs. @param foot position of the tree in `light`.
void growYear(TreeState& tree, const ShadeGrid& light, const glm::vec3& foot);

} // namespace osgTreeWind
