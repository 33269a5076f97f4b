// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/damage/BranchLoad.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <vector>

namespace osgTreeWind {

/// Factor by which what is seen exceeds the loads: the gain of the forest, above 0.
inline float exaggerationOf(const PlacedForest& forest) {
    return std::max(forest.description().gain, 1e-3f);
}

/// The base joint of a unit, with its stiffness and its breaking moment.
struct BreakableJoint {
    unsigned unit = 0;
    float stiffness = 0.0f; ///< N m/rad
    float limit = 0.0f;     ///< Breaking moment, N m; 0: unknown.

    /// Present moment at the joint from weight, inertia and wind, K theta, N m. @param tree its number in
    /// `motion`. @param vector ModalMotion::poseVector() of the tree.
    double moment(const ModalMotion& motion, std::size_t tree, const ModalMotion::PoseVector& vector) const {
        return static_cast<double>(stiffness) *
               static_cast<double>(glm::length(motion.unitAngles(tree, unit, vector)));
    }
};

/// Base joints of the 32 thickest boughs of a tree, thickest first; the limit follows from the diameter
/// (breakingMoment()). @param loads makeUnitLoads() of the tree.
std::vector<BreakableJoint> thickestBoughs(const TreeForm& tree, const std::vector<UnitLoad>& loads);

/// The present loads of all units of a tree.
std::vector<BranchLoad> branchLoadsOf(const PlacedForest& forest, std::size_t slot,
                                      const ModalMotion& motion);

} // namespace osgTreeWind
