// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <vector>

namespace osgTreeWind {

/// The base of a unit, what holds it and what that bears.
struct HeldJoint {
    unsigned unit = 0;
    float stiffness = 0.0f; ///< N m/rad
    float limit = 0.0f;     ///< N m; 0: not known.

    /// The moment of weight, inertia and the air there, K theta, N m. @param tree its number in `motion`.
    /// @param vector ModalMotion::poseVector() of it.
    double moment(const ModalMotion& motion, std::size_t tree, const float* vector) const;
    double moment(const ModalMotion& motion, std::size_t tree) const; ///< Works the vector out.
};

/// Bases of the 32 thickest boughs of a tree, the thickest first; each bears what wood as thick does
/// (breakingMoment()). @param loads makeUnitLoads() of the tree.
std::vector<HeldJoint> thickestBoughs(const SwayingTree& tree, const std::vector<UnitLoad>& loads);

} // namespace osgTreeWind
