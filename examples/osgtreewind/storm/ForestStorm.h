// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/damage/HeldJoint.h>
#include <osgTreeWind/wind/CanopyMap.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace osgTreeWind {

/// A forest in hours of storm: every tree among those that stand around it, under the law `modal` as trees
/// far away are taken.
///
/// Winds are means over open country (OpenCountry.h), 10 m above the ground, as weather services give them.
/// From WindCanopy::reference down they go on into the forest's own stands, or into the one that its
/// description gives.
class ForestStorm {
public:
    /// @param forest must outlive it. @param toward of the wind, horizontal, of length 1.
    /// @param most of its trees sway, the first ones; the others shelter them.
    ForestStorm(const PlacedForest& forest, const glm::vec3& toward, Executor executor,
                std::size_t most = std::numeric_limits<std::size_t>::max());

    /// The largest of an hour; 0 where no tree sways.
    struct Loads {
        double foot = 0.0;  ///< Moment at the foot, N m.
        double bough = 0.0; ///< Of the moment at the base of a bough, over what it bears (thickestBoughs()).
    };
    /// By slot. @param speed m/s, above 0. @param seed of its gusts.
    std::vector<Loads> hourOf(double speed, std::uint32_t seed) const;

    /// Per slot: the mean wind at the top of the stand that the tree is part of, at the top of the tree in
    /// the open, over that of the storm.
    std::vector<float> topWinds() const;

private:
    const PlacedForest& _forest;
    glm::vec3 _toward;
    Executor _executor;
    std::vector<std::size_t> _slots; ///< Of the trees that sway.
    struct Joints {
        HeldJoint foot;
        std::vector<HeldJoint> boughs;
    };
    std::vector<Joints> _joints;                 ///< Of these trees.
    std::shared_ptr<const ModalMotion> _resting; ///< Of the trees, in that order.
    std::shared_ptr<const CanopyMap> _canopy;
};

} // namespace osgTreeWind
