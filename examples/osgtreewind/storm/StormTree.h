// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/storm/CriticalSpeeds.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/damage/FootLoad.h>
#include <osgTreeWind/motion/modal/ModalPoses.h>
#include <osgTreeWind/wind/LayeredWind.h>

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace osgTreeWind {

/// The wind around a single tree, and the stand that it belongs to.
struct Storm {
    double speed = 10.0;  ///< Mean wind at the top of the canopy (in the open: of the tree), m/s.
    double spacing = 0.0; ///< Distance between trees of a uniform stand, metres; 0 for a tree in the open.
    std::uint32_t seed = 1;
};

/// State of the tree at one time.
struct StormState {
    glm::vec2 wind{0.0f}; ///< At the top, undisturbed by the tree, m/s.
    /// Moment of weight and air at the foot, N m; its direction is that in which the tree turns.
    glm::dvec2 moment{0.0};
    glm::dvec2 push{0.0};   ///< Moment of the air alone, without the overhanging weight, N m.
    glm::dvec2 strain{0.0}; ///< Strain of the wood at the foot of the trunk.
    glm::vec2 tilt{0.0f};   ///< Sine of the tilt of the trunk at half its height.
    glm::vec2 tip{0.0f};    ///< Displacement of the top of the trunk, metres.
};

/// One tree under the law `modal`, with its own modes, in a storm from the west.
class StormTree {
public:
    /// @param tree size, seed, leaves and openGrown are used; species and position are ignored.
    StormTree(const Species& species, const TreePlacement& tree, const Storm& storm);

    /// Simulates up to `time`, seconds, in small steps. It must be later than the last one; the first is 0.
    StormState advance(double time);

    /// Simulates up to `time`. @return the largest moment at the foot on the way, N m.
    double largestMoment(double time);
    const TreeStrength& strength() const { return _load.strength(); }
    /// Strain of the wood at the foot of the trunk at which the stem breaks; 0 if its strength is unknown.
    double strainLimit() const { return _load.strength().breaking * _strain; }
    /// Displacement of the top in the mean of all states so far, over that of a tree without weight; 1 in a
    /// calm.
    double weightFactor() const;

private:
    void advance(double time, const std::function<void()>& stepped);
    std::vector<UnitPose> posesOf(const ModalMotion::PoseVector& vector) const {
        return modalPoses(_forest, 0, _motion, vector);
    }
    glm::vec2 tipOf(const std::vector<UnitPose>& poses) const;

    PlacedForest _forest;
    ModalMotion _motion;
    LayeredWind _wind;
    FootLoad _load;
    double _time = 0.0;
    double _strain = 0.0; ///< Of the wood at the foot, per moment there, 1/(N m).
    /// Sum of the ModalMotion::poseVector() of all states.
    std::array<double, std::tuple_size_v<ModalMotion::PoseVector>> _poses{};
    std::size_t _states = 0;
    std::size_t _middle = 0; ///< Unit at half the height of the trunk.
};

/// Critical speeds of a tree. The speed of `storm` is ignored. The largest moment expected in an hour is the
/// mean of the largest moments of three hours, with the seeds `seed`, `seed` + 1 and `seed` + 2.
CriticalSpeeds criticalSpeedsOf(const Species& species, const TreePlacement& tree, const Storm& storm);

} // namespace osgTreeWind
