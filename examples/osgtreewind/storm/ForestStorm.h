// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/damage/BreakableJoint.h>
#include <osgTreeWind/wind/CanopyMap.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace osgTreeWind {

/// Simulates storms of one hour over a forest. Trees shelter each other and move under the law `modal` at the
/// level of detail of far trees.
///
/// Wind speeds are means 10 m above open country (OpenCountry.h), as weather services give them. Below
/// CanopySettings::reference the wind follows the stands of the forest, or the canopy that its description
/// gives.
class ForestStorm {
public:
    /// @param forest must outlive this object. @param toward horizontal unit vector along the wind.
    /// @param most number of trees that sway, the first ones; the others only shelter them.
    ForestStorm(const PlacedForest& forest, const glm::vec3& toward, Executor executor,
                std::size_t most = std::numeric_limits<std::size_t>::max());

    /// Largest loads of a tree in an hour; 0 for trees that do not sway.
    struct Loads {
        double foot = 0.0; ///< Moment at the foot, N m.
        double bough =
            0.0; ///< Moment at the base of a bough over the strength of the bough (thickestBoughs()).
    };
    /// Simulates an hour. @return loads by slot. @param speed m/s, above 0. @param seed of the gusts.
    std::vector<Loads> largestLoads(double speed, std::uint32_t seed) const;

    /// Mean wind at the top of the stand around a tree (in the open: at the top of the tree) over the mean
    /// wind of the storm, by slot.
    std::vector<float> topWinds() const;

private:
    const PlacedForest& _forest;
    glm::vec3 _toward;
    Executor _executor;
    std::vector<std::size_t> _slots; ///< Slots of the trees that sway.
    struct Joints {
        BreakableJoint foot;
        std::vector<BreakableJoint> boughs;
    };
    std::vector<Joints> _joints;                 ///< Joints of the trees in `_slots`.
    std::shared_ptr<const ModalMotion> _resting; ///< Motion of the trees in `_slots`, at rest.
    std::shared_ptr<const CanopyMap> _canopy;
};

} // namespace osgTreeWind
