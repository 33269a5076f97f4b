// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/storm/CriticalSpeeds.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/damage/HeldJoint.h>
#include <osgTreeWind/motion/modal/JointTree.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>
#include <osgTreeWind/wind/WindSampler.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace osgTreeWind {

/// A wind to stand in, and in what company.
struct Storm {
    double speed = 10.0;  ///< Mean at the top of the canopy, in the open at the top of the tree, m/s.
    double spacing = 0.0; ///< Of a stand of trees alike, metres; 0: in the open.
    std::uint32_t seed = 1;
};

/// A tree at one moment.
struct StormMoment {
    glm::vec2 wind{0.0f}; ///< At the top, free of the tree, m/s.
    /// Of its weight and the air on what holds it to the ground, by where it turns, N m.
    glm::dvec2 moment{0.0};
    glm::dvec2 push{0.0};   ///< That of the air alone: without the weight of what hangs over.
    glm::dvec2 strain{0.0}; ///< Of the wood at the foot of the trunk.
    glm::vec2 tilt{0.0f};   ///< Of the trunk at half its height, sine.
    glm::vec2 tip{0.0f};    ///< How far the top of the trunk is from where it rests, metres.
};

/// One tree under the law `modal`, with modes of its own, in a storm from the west.
class StormTree {
public:
    /// @param tree its size, seed, leaves and room; species and place do not count.
    StormTree(const Species& species, const TreePlacement& tree, const Storm& storm);

    /// Moves on to `time` > the last (seconds, 0 at first), in small steps.
    StormMoment advance(double time);

    /// Likewise. @return the largest moment on the way, N m.
    double largestMoment(double time);
    TreeStrength strength() const;

private:
    void advance(double time, const std::function<void()>& stepped);

    PlacedForest _forest;
    ModalMotion _motion;
    WindSampler _wind;
    std::vector<JointTree::Point> _weights;
    HeldJoint _foot;
    double _time = 0.0, _strain = 0.0;
    std::size_t _middle = 0, _top = 0; ///< Of the trunk's units.
};

/// Those of a tree in a storm of that company, whatever its speed: the largest moment to be expected in an
/// hour is the mean of the largest ones in three hours, with seeds from `seed` on.
CriticalSpeeds criticalSpeedsOf(const Species& species, const TreePlacement& tree, const Storm& storm);

} // namespace osgTreeWind
