// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/damage/TreeStrength.h>
#include <osgTreeWind/motion/damage/TreeSway.h>
#include <osgTreeWind/motion/laws/UnitPose.h>
#include <osgTreeWind/motion/modal/JointTree.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <vector>

namespace osgTreeWind {

/// The moments at the foot of a tree.
class FootLoad {
public:
    explicit FootLoad(const TreeForm& tree);

    /// Moment of weight, air and inertia, K theta, N m, in the tree's own axes; it points to where the tree
    /// turns. @param angles ModalMotion::unitAngles() of the first unit.
    glm::dvec2 moment(const glm::vec2& angles) const;
    /// The part of moment() that is of the overhanging weight.
    glm::dvec2 weightMoment(const std::vector<UnitPose>& poses) const;

    double stiffness() const { return _stiffness; }            ///< K, N m/rad.
    const TreeStrength& strength() const { return _strength; } ///< Resistance at the foot.
    std::size_t topUnit() const { return _top; }               ///< The last unit of the trunk.

private:
    double _stiffness;
    glm::vec3 _direction; ///< Of the first unit.
    TreeStrength _strength;
    std::vector<JointTree::Point> _weights;
    std::size_t _top = 0;
};

/// The unit with the highest tip.
std::size_t highestUnit(const Skeleton& skeleton);

/// The present sway of a tree, without `windAtTop`. Takes some tenths of a millisecond.
TreeSway swayOf(const PlacedForest& forest, std::size_t slot, const ModalMotion& motion);

} // namespace osgTreeWind
